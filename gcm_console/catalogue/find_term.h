#pragma once

#include <gcm_console/catalogue/system_items.h>
#include <tendon/base/result.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace re2 {
class RE2;
}  // namespace re2

namespace console {

/// A regular expression in RE2 syntax that ignores case. The time for a match is linear in the
/// length of the text, and its memory is limited to kMaxMemory.
class Expression {
 public:
  static constexpr std::size_t kLongest = 200;
  static constexpr std::size_t kMaxMemory = std::size_t{1} << 20U;

  /// Parses an expression. The error kInvalid says what is wrong, and in which part of the
  /// expression.
  static tendon::Result<Expression> Parse(std::string_view text);

  /// Returns true if the expression matches the text or a part of it.
  [[nodiscard]] bool IsIn(std::string_view text) const;

 private:
  explicit Expression(std::shared_ptr<const re2::RE2> compiled) : compiled_(std::move(compiled)) {}

  std::shared_ptr<const re2::RE2> compiled_;
};

/// One search word: a part of a path (ignoring case), a whole path with stars, or a regular
/// `/expression/` that matches a part of the path. With `type:` before it, the word is compared
/// with the kind ("command", "req"), the payload type or the class instead. `state:`, `host:` and
/// `proc:` work in the same way. A `!` before the word or after the colon negates the test.
class FindTerm {
 public:
  /// Parses a word. The error kInvalid names an unknown key and all known keys, or the mistake in
  /// an expression.
  static tendon::Result<FindTerm> Parse(const std::string& word);

  [[nodiscard]] bool Fits(const SystemItem& item) const;

 private:
  enum class Kind { kPath, kType, kState, kHost, kProcess };

  [[nodiscard]] bool IsIn(const std::string& text) const;
  [[nodiscard]] bool IsKind(const SystemItem& item) const;
  [[nodiscard]] bool IsType(const std::string& type) const;
  [[nodiscard]] bool Holds(const SystemItem& item) const;

  Kind kind_ = Kind::kPath;
  std::string text_;
  std::optional<Expression> expression_;  // set if the word is a regular expression
  bool is_negated_ = false;
};

}  // namespace console
