#include <program/command_line.h>
#include <tendon/base/name.h>
#include <tendon/base/printable.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

namespace program {
namespace {

/// Of the program and of the verbs that were given.
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

/// A word that nothing was expected for.
std::string Unexpected(const std::string& word, const CLI::App& app) {
  const std::string name = word.substr(0, word.find('='));
  if (!word.starts_with("-")) return "'" + name + "' is one word too many";
  const auto known = OptionNames(app);
  if (std::find(known.begin(), known.end(), name) != known.end()) {
    return "option '" + name + "' is in the wrong place";
  }
  return "no option '" + name + "'" + tendon::DidYouMean(name, known);
}

/// The library's words, without the repetition in them.
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

}  // namespace

std::string SentenceOf(const CLI::ParseError& mistake, const CLI::App& app,
                       const std::string& command) {
  std::string sentence = Words(mistake);
  // Only the first word matters; the library says them all, in the middle of its own.
  if (const auto rest = app.remaining(true); !rest.empty()) sentence = Unexpected(rest[0], app);
  const bool asks = sentence.ends_with("?");
  return tendon::Printable(sentence) + (asks ? " " : "; ") + command + " --help tells more";
}

std::string CheckPositive(const std::string& text) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  if (is_number && std::isfinite(number) && number > 0.0) return {};
  return "expected a number above 0, got '" + text + "'";
}

std::string CheckCount(const std::string& text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  if (is_number && number > 0) return {};
  return "expected a whole number above 0, got '" + text + "'";
}

std::string TransformDuration(std::string& text) {
  constexpr std::array<std::pair<std::string_view, double>, 3> kUnits = {
      {{"ms", 0.001}, {"min", 60.0}, {"s", 1.0}}};
  std::string number = text;
  double factor = 1.0;
  for (const auto& [unit, seconds] : kUnits) {
    if (!number.ends_with(unit)) continue;
    number.resize(number.size() - unit.size());
    factor = seconds;
    break;
  }
  if (!CheckPositive(number).empty()) {
    return "expected a time such as 500ms, 10s or 2min, got '" + text + "'";
  }
  text = std::to_string(std::stod(number) * factor);
  return {};
}

std::string TransformMilliseconds(std::string& text) {
  constexpr double kLongest = 3600000.0;
  const bool is_plain = text.find_first_not_of("0123456789.") == std::string::npos;
  std::string seconds = is_plain ? text + "ms" : text;
  const bool is_time = TransformDuration(seconds).empty();
  const double milliseconds = is_time ? std::stod(seconds) * 1000.0 : 0.0;
  if (milliseconds < 1.0 || milliseconds > kLongest) {
    return "expected a time of 1 ms to 60 min, such as 500ms, 5s or 2min, got '" + text + "'";
  }
  text = std::to_string(std::lround(milliseconds));
  return {};
}

}  // namespace program
