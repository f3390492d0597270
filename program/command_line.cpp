#include <program/command_line.h>

#include <tendon/base/name.h>
#include <tendon/base/text.h>
#include <tendon/payload/json/number_literal.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

namespace program {
namespace {

using Kind = tendon::Schema::Kind;
using Flaw = tendon::NumberFlaw;

/// Returns the option names of the program and of the given verbs.
std::vector<std::string> OptionNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  for (const CLI::App* part : app.get_subcommands()) {
    for (std::string& name : OptionNames(*part)) names.push_back(std::move(name));
  }
  return names;
}

/// Returns the sentence about an unexpected word.
std::string Unexpected(const std::string& word, const CLI::App& app) {
  const std::string name = word.substr(0, word.find('='));
  if (!word.starts_with("-")) return "'" + name + "' is one word too many";
  const auto known = OptionNames(app);
  if (std::find(known.begin(), known.end(), name) != known.end()) {
    return "option '" + name + "' is in the wrong place";
  }
  return "no option '" + name + "'" + tendon::DidYouMean(name, known);
}

/// Returns CLI11's message, without the part that repeats the word.
std::string Words(const CLI::ParseError& mistake) {
  std::string words = mistake.what();
  if (words == "A subcommand is required") return "a verb is missing";
  const std::string many = ": At Most 1 required but received ";
  if (const auto at = words.find(many); at != words.npos) {
    return words.substr(0, at) + " is given " + words.substr(at + many.size()) + " times";
  }
  const std::string none = ": 1 required ";
  if (const auto at = words.find(none); at != words.npos) {
    return words.substr(0, at) + " needs a value";
  }
  if (const auto at = words.find(" is required"); at != words.npos) {
    return words.substr(0, at) + " is missing";
  }
  return words;
}

/// Returns the remedy, if it is known: "; write 0.5s: use a point as the decimal sign".
std::string Hint(tendon::NumberLiteral word, const std::string& unit) {
  if (word.meant.empty()) return {};
  for (std::string& one : word.meant) one += unit;
  return "; " + FlawText(word);
}

/// Returns the number if it is finite and above 0.
std::optional<double> Positive(const tendon::NumberLiteral& word) {
  double number = 0.0;
  const char* const end = word.json.data() + word.json.size();
  const bool is_finite = std::from_chars(word.json.data(), end, number).ptr == end;
  return is_finite && number > 0.0 ? std::optional(number) : std::nullopt;
}

/// Returns the seconds in "500ms", "10s", "2min" or a plain number. If the text is invalid, `hint`
/// receives the remedy.
std::optional<double> SecondsIn(const std::string& text, std::string& hint) {
  constexpr std::array<std::pair<std::string_view, double>, 3> kUnits = {
      {{"ms", 0.001}, {"min", 60.0}, {"s", 1.0}}};
  for (const auto& [unit, factor] : kUnits) {
    const bool is_in_unit = text.ends_with(unit);
    if (!is_in_unit && factor != 1.0) continue;
    const std::string number = text.substr(0, text.size() - (is_in_unit ? unit.size() : 0));
    const tendon::NumberLiteral word = tendon::ReadNumberLiteral(Kind::kFloat64, number);
    hint = Hint(word, std::string(is_in_unit ? unit : ""));
    const auto seconds = Positive(word);
    const bool is_time = seconds && std::isfinite(*seconds * factor) && *seconds * factor > 0.0;
    return is_time ? std::optional(*seconds * factor) : std::nullopt;
  }
  return std::nullopt;
}

/// Returns the shortest text of a number, which is the same in every locale.
std::string TextOf(double number) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr};
}

}  // namespace

std::string SentenceOf(const CLI::ParseError& mistake, const CLI::App& app,
                       const std::string& command) {
  std::string sentence = Words(mistake);
  // Reports only the first unexpected word. CLI11's own sentence would list all of them.
  if (const auto rest = app.remaining(true); !rest.empty()) sentence = Unexpected(rest[0], app);
  const bool asks = sentence.ends_with("?");
  return tendon::Printable(sentence) + (asks ? " " : "; ") + command + " --help tells more";
}

std::string TransformPositive(std::string& text) {
  const tendon::NumberLiteral word = tendon::ReadNumberLiteral(Kind::kFloat64, text);
  if (const auto number = Positive(word)) {
    text = TextOf(*number);
    return {};
  }
  return "expected a number above 0, got '" + text + "'" + Hint(word, "");
}

std::string TransformCount(std::string& text) {
  const tendon::NumberLiteral word = tendon::ReadNumberLiteral(Kind::kUint64, text);
  if (word.flaw == Flaw::kNone && word.json != "0") {
    text = word.json;  // CLI11 would read 010 as an octal number, 8
    return {};
  }
  return "expected a whole number above 0, got '" + text + "'" + Hint(word, "");
}

std::string TransformDuration(std::string& text) {
  std::string hint;
  if (const auto seconds = SecondsIn(text, hint)) {
    text = TextOf(*seconds);
    return {};
  }
  return "expected a time such as 500ms, 10s or 2min, got '" + text + "'" + hint;
}

std::string TransformMilliseconds(std::string& text) {
  constexpr double kLongest = 3600000.0;
  const bool is_plain = tendon::ReadNumberLiteral(Kind::kFloat64, text).flaw == Flaw::kNone;
  std::string hint;
  const double milliseconds = SecondsIn(is_plain ? text + "ms" : text, hint).value_or(0.0) * 1000.0;
  const double whole = std::round(milliseconds);
  const bool is_whole = std::abs(milliseconds - whole) < 1e-6;  // 0.7s is not exactly 700 ms
  if (!is_whole || whole < 1.0 || whole > kLongest) {
    if (!is_whole) hint = "; write whole milliseconds";
    return "expected a time of 1 ms to 60 min, such as 500ms, 5s or 2min, got '" + text + "'" +
           hint;
  }
  text = std::to_string(static_cast<std::int64_t>(whole));
  return {};
}

}  // namespace program
