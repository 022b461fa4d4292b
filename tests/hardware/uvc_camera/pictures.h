// What the cameras show: pictures from recording folders, and which of them at the moment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "descriptors.h"
#include "usbip.h"

namespace tripoint::uvc {

/// The pictures of one camera, the same scene in each format.
struct Pictures {
  std::vector<Bytes> yuyv;
  std::vector<Bytes> mjpeg;  ///< without Huffman tables, as webcams send it

  [[nodiscard]] const Bytes& at(Format format, std::size_t index) const {
    return format == Format::kMjpeg ? mjpeg[index] : yuyv[index];
  }
};

struct RecordingFolders {
  std::filesystem::path yuyv;
  std::filesystem::path mjpeg;
};

/// Reads FOLDER/SIDE/*.yuyv and FOLDER/SIDE/*.jpg in the order of their names. Throws std::runtime_error when there is
/// none, when a raw picture has the wrong size or when the two folders differ in length.
Pictures pictures_from(const RecordingFolders& folders, const std::string& side);

/// Webcams leave the Huffman tables out of their MJPEG frames; the receiver has to know the standard ones (ITU-T T.81,
/// K.3).
Bytes without_huffman_tables(const Bytes& jpeg);

/// What a frame shows.
struct Showing {
  std::size_t picture = 0;
  bool restless = false;  ///< with a little noise of its own, as a sensor gives; else byte for byte as in its file
};

/// Loops over a range of the pictures, at first over all of them and without noise. Both cameras ask with the same
/// frame number and so show the same moment.
class Playlist {
 public:
  explicit Playlist(std::size_t pictures) : pictures_(pictures), count_(pictures) {}

  /// False when the range is empty or not there.
  bool show(std::size_t first, std::size_t count, bool restless);
  [[nodiscard]] Showing at(std::uint64_t frame) const;

 private:
  mutable std::mutex guard_;
  std::size_t pictures_;
  std::size_t first_ = 0;
  std::size_t count_;
  bool restless_ = false;
};

}  // namespace tripoint::uvc
