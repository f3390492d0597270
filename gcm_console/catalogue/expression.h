#pragma once

#include <tendon/base/result.h>

#include <cstddef>
#include <memory>
#include <string_view>
#include <utility>

namespace re2 {
class RE2;
}  // namespace re2

namespace console {

/// A regular expression in RE2 syntax that ignores upper and lower case. Matching takes linear time
/// in the text and at most kMostMemory.
class Expression {
 public:
  static constexpr std::size_t kLongest = 200;
  static constexpr std::size_t kMostMemory = std::size_t{1} << 20U;

  /// The error, kInvalid, says what is wrong and in which part.
  static tendon::Result<Expression> Parse(std::string_view text);

  /// True if a part of the text matches.
  [[nodiscard]] bool IsIn(std::string_view text) const;

 private:
  explicit Expression(std::shared_ptr<const re2::RE2> compiled) : compiled_(std::move(compiled)) {}

  std::shared_ptr<const re2::RE2> compiled_;
};

}  // namespace console
