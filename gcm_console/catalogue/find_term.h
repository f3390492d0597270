#pragma once

#include <gcm_console/catalogue/expression.h>
#include <gcm_console/catalogue/things.h>
#include <tendon/base/result.h>

#include <optional>
#include <string>

namespace console {

/// One search word: part of a path (ignoring case), a whole path with stars, or a regular
/// `/expression/` that matches a part of the path. `type:` searches the kind ("command", "req"),
/// payload type or class; `state:`, `host:` and `proc:` work likewise. `!` before a word or after
/// the colon negates it.
class FindTerm {
 public:
  /// The error, kInvalid, names an unknown key and the known ones, or the mistake in an expression.
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
  std::optional<Expression> expression_;  // the parsed regular expression, if the word is one
  bool is_negated_ = false;
};

}  // namespace console
