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

/// A regular expression as RE2 knows them, in upper or lower case. None takes longer than in
/// proportion to the text, and none more memory than kMostMemory.
class Expression {
 public:
  static constexpr std::size_t kLongest = 200;
  static constexpr std::size_t kMostMemory = std::size_t{1} << 20U;

  /// kInvalid says what is wrong, and with which part.
  static tendon::Result<Expression> Parse(std::string_view text);

  /// Whether a part of the text fits.
  [[nodiscard]] bool IsIn(std::string_view text) const;

 private:
  explicit Expression(std::shared_ptr<const re2::RE2> compiled) : compiled_(std::move(compiled)) {}

  std::shared_ptr<const re2::RE2> compiled_;
};

}  // namespace console
