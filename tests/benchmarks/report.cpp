#include <benchmarks/report.h>

#include <array>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

namespace tendon::benchmark {
namespace {

std::string Text(std::optional<double> number) {
  if (!number) return "-";
  std::ostringstream text;
  text << std::setprecision(3) << *number;
  return text.str();
}

/// Returns true if the case reaches the goal; no value if there is no goal.
std::optional<bool> Reaches(const Case& one, const std::optional<Outcome>& outcome,
                            std::optional<double> goal) {
  if (!goal || !outcome) return std::nullopt;
  return one.ratio == Ratio::kOfTimes ? outcome->ratio <= *goal : outcome->ratio >= *goal;
}

std::string Verdict(const Case& one, const std::optional<Outcome>& outcome) {
  if (!outcome) return "not measurable here";
  std::string verdict = "reported";
  if (const auto holds = Reaches(one, outcome, one.gate)) verdict = *holds ? "yes" : "NO";
  if (Reaches(one, outcome, one.stretch) == true) verdict = "stretch";
  if (outcome->disturbed > 0) {
    verdict += " (" + std::to_string(outcome->disturbed) + " of " + std::to_string(outcome->pairs) +
               " disturbed)";
  }
  return verdict;
}

template <typename T>
nlohmann::json OrNull(const std::optional<T>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}

void PrintColumns(std::ostream& out, const std::array<std::string, 9>& cells) {
  constexpr std::array<int, 8> kWidths{6, 52, 9, 9, 5, 9, 7, 8};
  for (std::size_t i = 0; i < kWidths.size(); ++i) {
    out << (i < 2 ? std::left : std::right) << std::setw(kWidths[i]) << cells[i] << ' ';
  }
  out << ' ' << cells.back() << std::endl;
}

}  // namespace

void PrintHeading(std::ostream& out) {
  PrintColumns(out, {"id", "", "ours", "floor", "unit", "ratio", "gate", "stretch", "holds"});
}

void PrintLine(std::ostream& out, const Case& one, const std::optional<Outcome>& outcome) {
  const auto figure = [&](auto member) -> std::string {
    return outcome ? Text((*outcome).*member) : "-";
  };
  PrintColumns(out,
               {one.id, one.what, figure(&Outcome::ours), figure(&Outcome::floor), one.unit,
                figure(&Outcome::ratio), Text(one.gate), Text(one.stretch), Verdict(one, outcome)});
}

nlohmann::json ToJson(const Case& one, const std::optional<Outcome>& outcome) {
  const auto figure = [&](auto member) {
    return outcome ? nlohmann::json((*outcome).*member) : nlohmann::json();
  };
  return {{"id", one.id},
          {"what", one.what},
          {"unit", one.unit},
          {"ours", figure(&Outcome::ours)},
          {"floor", outcome ? OrNull(outcome->floor) : nlohmann::json()},
          {"ratio", figure(&Outcome::ratio)},
          {"gate", OrNull(one.gate)},
          {"stretch", OrNull(one.stretch)},
          {"holds", OrNull(Reaches(one, outcome, one.gate))},
          {"reaches_stretch", OrNull(Reaches(one, outcome, one.stretch))},
          {"pairs", figure(&Outcome::pairs)},
          {"disturbed", figure(&Outcome::disturbed)}};
}

}  // namespace tendon::benchmark
