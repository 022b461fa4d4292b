// A stereo pair of MJPEG pictures measured around a forecast, as cameras and line do it together.
#pragma once

#include <cstdint>

#include "bench/stereo_pair.h"
#include "capture/band_choice.h"
#include "capture/mjpeg_decoder.h"
#include "line/model.h"
#include "line/monitor/monitor.h"
#include "values/forecast.h"
#include "values/side.h"

namespace tripoint::bench {

/// Pair after pair of one motion. The forecast is the line's own, of a target whose rotation is known.
class TrackedPair {
 public:
  explicit TrackedPair(ImageSize size);

  /// @return how many points in space came out
  std::size_t measure(const PairBytes& pair);

  /// How many pictures of the last pair were decoded whole: 0 to 2.
  [[nodiscard]] std::size_t whole_pictures() const { return whole_; }

 private:
  Picture decoded(const PairBytes& pair, Side side);
  void remember(const Picture& picture, Side side);
  void learn();

  ImageSize size_;
  PairMeasurer measurer_;
  LineModel model_;
  Monitor monitor_;
  Forecast forecast_;
  PerSide<MjpegDecoder> decoders_;
  PerSide<Sightings> sightings_;
  std::uint32_t frame_ = 0;
  TimePoint exposed_{};
  std::size_t whole_ = 0;
};

}  // namespace tripoint::bench
