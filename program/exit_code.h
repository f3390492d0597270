#pragma once

#include <tendon/base/error.h>

namespace program {

/// The exit codes of the programs; scripts rely on the numbers (`gcm help exit-codes`).
enum ExitCode : int {
  kOk = 0,
  kRefused = 1,
  kUsage = 2,
  kUnreachable = 3,
  kNotFound = 4,
  kIncompatible = 5,
  kTimeout = 6,
  kDenied = 7,
  kPartial = 8,  ///< only some of several actions succeeded
  kInterrupted = 130,
};

/// Returns the exit code of a failed request.
constexpr ExitCode ExitCodeOf(tendon::ErrorCode code) {
  switch (code) {
    case tendon::ErrorCode::kFailed:
    case tendon::ErrorCode::kExists:
      return kRefused;
    case tendon::ErrorCode::kInvalid:
      return kUsage;
    case tendon::ErrorCode::kUnreachable:
      return kUnreachable;
    case tendon::ErrorCode::kNotFound:
      return kNotFound;
    case tendon::ErrorCode::kIncompatible:
      return kIncompatible;
    case tendon::ErrorCode::kTimeout:
      return kTimeout;
    case tendon::ErrorCode::kDenied:
      return kDenied;
  }
  return kRefused;
}

}  // namespace program
