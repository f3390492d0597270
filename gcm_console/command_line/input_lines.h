#pragma once

#include <tendon/base/result.h>

#include <istream>
#include <optional>
#include <string>

namespace console {

/// Reads the lines of a stream, at most 1 MiB each. After the last line, error() distinguishes the
/// end of the stream from a read error.
class InputLines {
 public:
  explicit InputLines(std::istream& in) : in_(in) {}

  /// Returns false if there are no more lines.
  bool Next(std::string& line);
  [[nodiscard]] const std::optional<tendon::Error>& error() const { return error_; }

 private:
  std::istream& in_;
  std::optional<tendon::Error> error_;
};

/// Reads the whole stream; kInvalid above 16 MiB or on a read error.
tendon::Result<std::string> AllOf(std::istream& in);

}  // namespace console
