#include <benchmarks/measurement.h>
#include <benchmarks/memory.h>
#include <benchmarks/report.h>
#include <tendon/base/log.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

namespace tendon::benchmark {
namespace {

struct Options {
  std::optional<std::string> json;
  std::vector<std::string> only;
  Effort effort;
};

std::vector<Case> AllCases(const Effort& effort) {
  std::vector<Case> all;
  for (const auto& make : {QueueCases, WaitingCases, TableCases, PeriodCases, RecordingCases,
                           NetworkCases, PlotCases, WindowCases}) {
    for (Case& one : make(effort)) all.push_back(std::move(one));
  }
  return all;
}

/// Returns the cases with these ids, in the order of the table.
std::vector<Case> Choose(std::vector<Case> cases, const std::vector<std::string>& ids) {
  std::string known;
  for (const Case& one : cases) known += (known.empty() ? "" : ", ") + one.id;
  for (const std::string& id : ids) {
    if (std::ranges::find(cases, id, &Case::id) == cases.end()) {
      throw CLI::ValidationError("--only", "there is no case '" + id + "'; there are " + known);
    }
  }
  if (!ids.empty()) {
    std::erase_if(cases, [&](const Case& one) { return std::ranges::count(ids, one.id) == 0; });
  }
  return cases;
}

/// Returns false if the file cannot be written. The file is opened before anything is measured.
bool Report(const std::vector<Case>& cases, const Options& options) {
  std::ofstream file;
  if (options.json) file.open(*options.json);
  if (!file) return false;
  nlohmann::json entries = nlohmann::json::array();
  PrintHeading(std::cout);
  for (const Case& one : cases) {
    const auto outcome = Measure(one, options.effort);
    PrintLine(std::cout, one, outcome);
    entries.push_back(ToJson(one, outcome));
  }
  if (!options.json) return true;
  file << entries.dump(2) << '\n';
  file.close();
  return file.good();
}

int Main(int argc, char** argv) {
  Options options;
  CLI::App app(
      "Measures what is promised of speed, each against a floor in this program. Use the preset "
      "release. A gate that is missed is printed, and no failure: machines are shared.");
  app.add_option("--json", options.json, "also writes the table to this file");
  app.add_option("--only", options.only, "the cases to measure: Q1,S3")->delimiter(',');
  CLI::Option* const repetitions =
      app.add_option("--repetitions", options.effort.repetitions, "undisturbed pairs a case")
          ->check(CLI::Range(1, 1000))
          ->capture_default_str();
  app.add_flag("--tiny", options.effort.is_tiny, "shows that the cases run, measures nothing")
      ->excludes(repetitions);
  try {
    app.parse(argc, argv);
    if (options.effort.is_tiny) options.effort.repetitions = 1;
    KeepMemory();
    // Hundreds of processes start and end here. Without this, each of them would log several lines.
    SetLogLevel(LogLevel::kWarning);
    const auto cases = Choose(AllCases(options.effort), options.only);
    if (Report(cases, options)) return 0;
    std::cerr << "report: cannot write '" << *options.json << "'" << '\n';
    return 1;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& failure) {
    std::cerr << "report: " << failure.what() << '\n';
    return 1;
  }
}

}  // namespace
}  // namespace tendon::benchmark

int main(int argc, char** argv) { return tendon::benchmark::Main(argc, argv); }
