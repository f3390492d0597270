#pragma once

#include <tendon/base/result.h>

#include <istream>
#include <optional>
#include <string>

namespace console {

/// Reads the lines of a stream; a line may have at most 1 MiB. After the last line, error() shows
/// whether the stream has ended or could not be read.
class InputLines {
 public:
  explicit InputLines(std::istream& in) : in_(in) {}

  /// Reads the next line. Returns false if there are no more lines.
  bool Next(std::string& line);
  [[nodiscard]] const std::optional<tendon::Error>& error() const { return error_; }

 private:
  std::istream& in_;
  std::optional<tendon::Error> error_;
};

/// Reads the whole stream. Returns kInvalid if it has more than 16 MiB or cannot be read.
tendon::Result<std::string> AllOf(std::istream& in);

}  // namespace console
