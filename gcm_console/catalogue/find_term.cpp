#include <gcm_console/catalogue/find_term.h>
#include <tendon/base/path.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>
#include <vector>

namespace console {
namespace {

std::string Lower(std::string text) {
  for (char& letter : text) {
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return text;
}

/// "/.../".
bool IsExpression(const std::string& text) {
  return text.size() > 1 && text.starts_with('/') && text.ends_with('/');
}

}  // namespace

tendon::Result<FindTerm> FindTerm::Parse(const std::string& word) {
  struct Key {
    const char* name;
    Kind kind;
  };
  static constexpr Key kKeys[] = {{"type", Kind::kType},
                                  {"state", Kind::kState},
                                  {"host", Kind::kHost},
                                  {"proc", Kind::kProcess}};
  FindTerm term;
  std::string text = word;
  const auto take_negation = [&] {
    if (!text.starts_with('!')) return;
    term.is_negated_ = !term.is_negated_;
    text.erase(0, 1);
  };
  take_negation();
  const auto colon = text.find(':');
  if (colon != std::string::npos && !IsExpression(text)) {
    const std::string name = text.substr(0, colon);
    const auto* key = std::ranges::find(kKeys, name, &Key::name);
    if (key == std::end(kKeys)) {
      std::vector<std::string> names;
      for (const Key& one : kKeys) names.emplace_back(one.name);
      const std::string near = tendon::DidYouMean(name, names);
      return tendon::Error{tendon::ErrorCode::kInvalid,
                           "'" + word + "': there is no '" + name + ":'" + near +
                               (near.empty() ? "; " : " ") +
                               "known are type:, state:, host: and proc:"};
    }
    term.kind_ = key->kind;
    text.erase(0, colon + 1);
    take_negation();
    if (text.empty()) {
      return tendon::Error{tendon::ErrorCode::kInvalid,
                           "'" + word + "': a value is missing after '" + name + ":'"};
    }
  }
  term.text_ = text;
  if (IsExpression(text)) {
    auto expression = Expression::Parse(std::string_view(text).substr(1, text.size() - 2));
    if (!expression) {
      return tendon::Error{expression.error().code,
                           "'" + word + "': " + expression.error().message};
    }
    term.expression_ = *std::move(expression);
  }
  return term;
}

bool FindTerm::Fits(const Thing& thing) const { return Holds(thing) != is_negated_; }

/// A word with a star is a pattern for the whole text; any other word must be a part of the text.
/// Ignores case.
bool FindTerm::IsIn(const std::string& text) const {
  if (expression_) return expression_->IsIn(text);
  if (text_.find('*') != std::string::npos) return tendon::MatchesGlob(text_, text);
  return Lower(text).find(Lower(text_)) != std::string::npos;
}

/// Accepts "command", "required interface", or the short form of `ls --type`: "req".
bool FindTerm::IsNoun(const Thing& thing) const {
  if (expression_) return expression_->IsIn(thing.noun);
  const auto is_code = [&](const Noun& noun) {
    return noun.name == thing.noun && noun.code == Lower(text_);
  };
  return thing.noun.starts_with(Lower(text_)) || std::ranges::any_of(kNouns, is_code);
}

/// Accepts the whole of "arm.LinkId -> geometry_msgs.Pose" or one of the two.
bool FindTerm::IsType(const std::string& type) const {
  constexpr std::string_view kArrow = " -> ";
  if (type.empty()) return false;
  if (IsIn(type)) return true;
  const auto arrow = type.find(kArrow);
  return arrow != type.npos &&
         (IsIn(type.substr(0, arrow)) || IsIn(type.substr(arrow + kArrow.size())));
}

bool FindTerm::Holds(const Thing& thing) const {
  switch (kind_) {
    case Kind::kType:
      return IsNoun(thing) || IsType(thing.type);
    case Kind::kState:
      return !thing.state.empty() && IsIn(thing.state);
    case Kind::kHost:
      return IsIn(thing.host);
    case Kind::kProcess:
      return IsIn(thing.path.substr(0, thing.path.find('/')));
    case Kind::kPath:
      break;
  }
  return IsIn(thing.path);
}

}  // namespace console
