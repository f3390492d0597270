#include <gcm_console/catalogue/find_term.h>

#include <re2/re2.h>
#include <tendon/base/path.h>
#include <tendon/base/text.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace console {
namespace {

using tendon::Error;
using tendon::ErrorCode;

re2::StringPiece PieceOf(std::string_view text) { return {text.data(), text.size()}; }

/// Returns the mistake in an expression. RE2 appends the wrong part to its message after a colon.
std::string MistakeIn(const re2::RE2& expression) {
  const std::string& part = expression.error_arg();
  std::string mistake = expression.error();
  if (mistake.ends_with(": " + part)) {
    mistake.erase(mistake.size() - part.size() - 2);
    if (!part.empty()) mistake += " at '" + part + "'";
  }
  return mistake + "; expected an expression such as Get|Set";
}

/// Returns true for "/.../".
bool IsExpression(const std::string& text) {
  return text.size() > 1 && text.starts_with('/') && text.ends_with('/');
}

}  // namespace

tendon::Result<Expression> Expression::Parse(std::string_view text) {
  if (text.empty()) {
    return Error{ErrorCode::kInvalid,
                 "an empty expression matches everything; expected an expression such as Get|Set"};
  }
  if (text.size() > kLongest) {
    return Error{ErrorCode::kInvalid, "an expression may have at most " + std::to_string(kLongest) +
                                          " bytes, but the given expression has " +
                                          std::to_string(text.size())};
  }
  re2::RE2::Options options;
  options.set_case_sensitive(false);
  options.set_log_errors(false);
  options.set_max_mem(kMaxMemory);
  auto compiled = std::make_shared<const re2::RE2>(PieceOf(text), options);
  if (!compiled->ok()) return Error{ErrorCode::kInvalid, MistakeIn(*compiled)};
  return Expression(std::move(compiled));
}

bool Expression::IsIn(std::string_view text) const {
  return re2::RE2::PartialMatch(PieceOf(text), *compiled_);
}

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
                               "the known keys are type:, state:, host: and proc:"};
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

bool FindTerm::Fits(const SystemItem& item) const { return Holds(item) != is_negated_; }

/// A word with a star must match the whole text; any other word must occur in the text. Ignores
/// case.
bool FindTerm::IsIn(const std::string& text) const {
  if (expression_) return expression_->IsIn(text);
  if (text_.find('*') != std::string::npos) return tendon::MatchesGlob(text_, text);
  return tendon::InLowerCase(text).find(tendon::InLowerCase(text_)) != std::string::npos;
}

/// Accepts the kind, such as "command" or "required interface", and its code for `ls --type`, such
/// as "req".
bool FindTerm::IsKind(const SystemItem& item) const {
  if (expression_) return expression_->IsIn(item.kind);
  const auto is_code = [&](const SystemItemKind& kind) {
    return kind.name == item.kind && kind.code == tendon::InLowerCase(text_);
  };
  return item.kind.starts_with(tendon::InLowerCase(text_)) ||
         std::ranges::any_of(kSystemItemKinds, is_code);
}

/// The word may match the whole of "arm.LinkId -> geometry_msgs.Pose", or one of the two types.
bool FindTerm::IsType(const std::string& type) const {
  constexpr std::string_view kArrow = " -> ";
  if (type.empty()) return false;
  if (IsIn(type)) return true;
  const auto arrow = type.find(kArrow);
  return arrow != type.npos &&
         (IsIn(type.substr(0, arrow)) || IsIn(type.substr(arrow + kArrow.size())));
}

bool FindTerm::Holds(const SystemItem& item) const {
  switch (kind_) {
    case Kind::kType:
      return IsKind(item) || IsType(item.type);
    case Kind::kState:
      return !item.state.empty() && IsIn(item.state);
    case Kind::kHost:
      return IsIn(item.host);
    case Kind::kProcess:
      return IsIn(item.path.substr(0, item.path.find('/')));
    case Kind::kPath:
      break;
  }
  return IsIn(item.path);
}

}  // namespace console
