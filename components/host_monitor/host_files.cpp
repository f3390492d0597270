#include <components/host_monitor/host_files.h>

#include <components/host_monitor/host_text.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <utility>

namespace host {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxThermometers = 64;
constexpr std::size_t kLongestName = 32;

/// Returns the entries of `folder` whose names begin with `beginning`, sorted by name.
std::vector<fs::path> Entries(const fs::path& folder, const std::string& beginning) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (at->path().filename().string().starts_with(beginning)) entries.push_back(at->path());
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// Returns the first line of a file as a name, or `otherwise` if there is no such line.
std::string ReadName(const fs::path& file, const std::string& otherwise) {
  std::string name = ReadText(file);
  name.resize(std::min({name.find('\n'), name.size(), kLongestName}));
  return name.empty() ? otherwise : name;
}

}  // namespace

std::string ReadText(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

Thermometers::Thermometers(const fs::path& root) {
  for (const fs::path& zone : Entries(root / "sys/class/thermal", "thermal_zone")) {
    Add(ReadName(zone / "type", zone.filename().string()), zone / "temp");
  }
  for (const fs::path& chip : Entries(root / "sys/class/hwmon", "hwmon")) {
    const std::string chip_name = ReadName(chip / "name", chip.filename().string());
    for (const fs::path& input : Entries(chip, "temp")) {
      constexpr std::string_view kInput = "_input";
      std::string name = input.filename().string();
      if (!name.ends_with(kInput)) continue;
      name.resize(name.size() - kInput.size());
      Add(chip_name + " " + ReadName(chip / (name + "_label"), name), input);
    }
  }
}

void Thermometers::Read(Temperatures& temperatures) const {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  temperatures.sensors.resize(files_.size());
  for (std::size_t i = 0; i < files_.size(); ++i) {
    temperatures.sensors[i].sensor = files_[i].sensor;
    temperatures.sensors[i].value = ParseTemperature(ReadText(files_[i].path)).value_or(kNone);
  }
}

void Thermometers::Add(std::string sensor, const fs::path& path) {
  const bool is_there = ParseTemperature(ReadText(path)).has_value();
  if (!is_there || files_.size() == kMaxThermometers) return;
  files_.push_back({std::move(sensor), path});
}

}  // namespace host
