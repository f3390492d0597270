#pragma once

#include <tendon/base/result.h>

#include <istream>
#include <optional>
#include <string>

namespace console {

/// The lines of a stream, of at most 1 MiB each. After the last one `error()` says whether that was
/// the end, or the rest cannot be read.
class InputLines {
 public:
  explicit InputLines(std::istream& in) : in_(in) {}

  /// False where there is no further one.
  bool Next(std::string& line);
  [[nodiscard]] const std::optional<tendon::Error>& error() const { return error_; }

 private:
  std::istream& in_;
  std::optional<tendon::Error> error_;
};

/// All of a stream; kInvalid for more than 16 MiB, or where it cannot be read.
tendon::Result<std::string> AllOf(std::istream& in);

}  // namespace console
