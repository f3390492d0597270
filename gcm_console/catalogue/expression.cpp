#include <gcm_console/catalogue/expression.h>
#include <re2/re2.h>

#include <string>

namespace console {
namespace {

using tendon::Error;
using tendon::ErrorCode;

re2::StringPiece PieceOf(std::string_view text) { return {text.data(), text.size()}; }

/// The wrong part of an expression, which RE2 appends to its message after a colon.
std::string MistakeIn(const re2::RE2& expression) {
  const std::string& part = expression.error_arg();
  std::string mistake = expression.error();
  if (mistake.ends_with(": " + part)) {
    mistake.erase(mistake.size() - part.size() - 2);
    if (!part.empty()) mistake += " at '" + part + "'";
  }
  return mistake + "; expected an expression such as Get|Set";
}

}  // namespace

tendon::Result<Expression> Expression::Parse(std::string_view text) {
  if (text.empty()) return Error{ErrorCode::kInvalid, "an empty expression matches everything"};
  if (text.size() > kLongest) {
    return Error{ErrorCode::kInvalid, "an expression is at most " + std::to_string(kLongest) +
                                          " bytes long, this one has " +
                                          std::to_string(text.size())};
  }
  re2::RE2::Options options;
  options.set_case_sensitive(false);
  options.set_log_errors(false);
  options.set_max_mem(kMostMemory);
  auto compiled = std::make_shared<const re2::RE2>(PieceOf(text), options);
  if (!compiled->ok()) return Error{ErrorCode::kInvalid, MistakeIn(*compiled)};
  return Expression(std::move(compiled));
}

bool Expression::IsIn(std::string_view text) const {
  return re2::RE2::PartialMatch(PieceOf(text), *compiled_);
}

}  // namespace console
