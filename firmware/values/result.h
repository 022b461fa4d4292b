// What a function returns when the world may refuse: a value, or a documented code and one line for the log.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include <tl/expected.hpp>

namespace tripoint {

/// Every way in which the world can refuse. The remedy stands in the message made where the thing is known.
enum class ErrorCode {
  // files and configuration
  kCannotRead,   ///< a file or folder is missing or not readable
  kCannotWrite,  ///< a file could not be written whole
  kMalformed,    ///< a file is not in its format: syntax, truncated, damaged
  kUnknownKey,   ///< a key nobody reads, most often a spelling mistake
  kMissingKey,   ///< a required key is absent
  kOutOfRange,   ///< a value outside its permitted range
  kMismatch,     ///< two things that must belong together do not (calibration and camera)
  // geometry
  kNoConvergence,       ///< an iteration did not settle: the input is outside the model's domain
  kBehindCamera,        ///< the point lies behind a lens centre
  kRaysAlmostParallel,  ///< the viewing rays do not meet at a usable angle
  kDegenerate,          ///< points coincide or lie on one line
  // devices
  kDeviceMissing,   ///< no such device (ENODEV, ENOENT), or it was unplugged
  kDeviceBusy,      ///< another program uses the device (EBUSY)
  kNoSuchFormat,    ///< the camera does not offer this pixel format, size or rate
  kNoBandwidth,     ///< the bus cannot carry the stream (ENOSPC)
  kControlRefused,  ///< a control does not exist, or reads back another value
  kTimeout,         ///< nothing arrived within the limit
  kCorruptFrame,    ///< a frame arrived damaged: truncated or not decodable
  kEndOfStream,     ///< a recording has no more frames
  kDeviceFault,     ///< any other error of a driver
  // sockets
  kAddressInUse,  ///< the port is taken
};

/// A documented code plus one line for the log; `message` may stay empty inside the line.
struct Error {
  ErrorCode code;
  std::string message = {};
};

template <typename T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> failure(ErrorCode code, std::string message = {}) {
  return tl::make_unexpected(Error{code, std::move(message)});
}

}  // namespace tripoint
