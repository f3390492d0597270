#pragma once

#include <gtest/gtest.h>
#include <support/program.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

/// The scripts in oracle/. They use programs that others have written: the packages of @mcap and
/// @foxglove in oracle/package.json, which Foxglove uses, too.
namespace tendon::recording {

/// The reason to skip a test if HasOracle() is false.
inline constexpr const char* kNoOracle =
    "no program of others reads our recordings, because its packages are not installed: run "
    "tools/setup --oracles";

/// Returns true if `tools/setup --oracles` has installed the packages.
inline bool HasOracle() {
  const auto lock_file_in = [](const std::filesystem::path& folder) {
    std::ifstream stream(folder / "package-lock.json", std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  return lock_file_in(TENDON_RECORDING_ORACLE_PACKAGES) == lock_file_in(TENDON_RECORDING_ORACLE);
}

/// Runs a script with a file. Returns the lines that the script prints.
inline std::vector<nlohmann::json> RunOracle(const std::string& script,
                                             const std::filesystem::path& file,
                                             const std::vector<std::string>& options = {}) {
  Program::Words command{"/usr/bin/env", "node",
                         std::filesystem::path(TENDON_RECORDING_ORACLE) / script,
                         TENDON_RECORDING_ORACLE_PACKAGES, file};
  command.insert(command.end(), options.begin(), options.end());
  const Outcome outcome = RunProgram(command);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  std::vector<nlohmann::json> lines;
  std::istringstream text(outcome.out);
  for (std::string line; std::getline(text, line);) lines.push_back(nlohmann::json::parse(line));
  return lines;
}

/// Returns the lines of one kind, such as "message".
inline std::vector<nlohmann::json> OfKind(const std::vector<nlohmann::json>& lines,
                                          const std::string& kind) {
  std::vector<nlohmann::json> all;
  std::ranges::copy_if(lines, std::back_inserter(all),
                       [&](const nlohmann::json& line) { return line["kind"] == kind; });
  return all;
}

/// Groups messages by their topic.
inline std::map<std::string, std::vector<nlohmann::json>> ByTopic(
    const std::vector<nlohmann::json>& messages) {
  std::map<std::string, std::vector<nlohmann::json>> all;
  for (const nlohmann::json& message : messages) all[message["topic"]].push_back(message);
  return all;
}

}  // namespace tendon::recording
