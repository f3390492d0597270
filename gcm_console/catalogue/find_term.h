#pragma once

#include <gcm_console/catalogue/expression.h>
#include <gcm_console/catalogue/things.h>
#include <tendon/base/result.h>

#include <optional>
#include <string>

namespace console {

/// One word by which things are found: a part of a path, in upper or lower case, or all of it with
/// stars, or a part that fits a regular `/expression/`; `type:` what it is ("command", "req") or
/// its payload type or class, `state:`, `host:` and `proc:` likewise. `!` before a word, or behind
/// the colon, turns it around.
class FindTerm {
 public:
  /// kInvalid names the key that there is not, and those that there are; or what is wrong with an
  /// expression.
  static tendon::Result<FindTerm> Parse(const std::string& word);

  [[nodiscard]] bool Fits(const Thing& thing) const;

 private:
  enum class Kind { kPath, kType, kState, kHost, kProcess };

  [[nodiscard]] bool IsIn(const std::string& text) const;
  [[nodiscard]] bool IsNoun(const Thing& thing) const;
  [[nodiscard]] bool IsType(const std::string& type) const;
  [[nodiscard]] bool Holds(const Thing& thing) const;

  Kind kind_ = Kind::kPath;
  std::string text_;
  std::optional<Expression> expression_;  // that the text is
  bool is_negated_ = false;
};

}  // namespace console
