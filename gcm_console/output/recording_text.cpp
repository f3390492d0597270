#include <gcm_console/output/recording_text.h>

#include <gcm_console/output/text.h>

#include <array>

namespace console {

std::string SizeText(std::uint64_t bytes) {
  constexpr std::uint64_t kStep = 1000;
  if (bytes < kStep) return std::to_string(bytes) + " B";
  constexpr std::array kUnits = {"kB", "MB", "GB", "TB", "PB", "EB"};
  auto value = static_cast<double>(bytes) / kStep;
  std::size_t unit = 0;
  for (; value >= kStep && unit + 1 < kUnits.size(); ++unit) value /= kStep;
  return Fixed(value, 1) + " " + kUnits[unit];
}

std::vector<std::string> ProblemTexts(const std::vector<tendon::mcap::Problem>& problems,
                                      std::uint64_t count) {
  std::vector<std::string> all;
  for (const auto& problem : problems) all.push_back(problem.sentence);
  if (count > problems.size()) {
    all.push_back("and " + std::to_string(count - problems.size()) + " more problems");
  }
  return all;
}

}  // namespace console
