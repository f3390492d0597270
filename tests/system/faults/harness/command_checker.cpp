#include "system/faults/harness/command_checker.h"

#include <tests/system/faults/instruments/numbered.h>

#include <fstream>
#include <map>
#include <sstream>

namespace faults {
namespace {

namespace fs = std::filesystem;
using Key = std::pair<std::uint64_t, std::uint64_t>;  // source and number

std::string NameOf(const Key& key) {
  return "command " + std::to_string(key.second) + " of " + std::to_string(key.first);
}

template <typename Read>
void ForEachLine(const fs::path& file, Read read) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) read(line);
}

std::map<Key, std::string> ReadGiven(const fs::path& file) {
  std::map<Key, std::string> given;
  const std::uint64_t source = std::stoull(file.filename().string().substr(6));
  ForEachLine(file, [&](const std::string& line) {
    const auto space = line.find(' ');
    given[{source, std::stoull(line)}] = line.substr(space + 1);
  });
  return given;
}

void ReadExecuted(const fs::path& file, std::map<Key, int>& executed, CommandVerdict& verdict) {
  ForEachLine(file, [&](const std::string& line) {
    Numbered command;
    std::istringstream(line) >> command.source >> command.number >> command.check;
    ++executed[{command.source, command.number}];
    if (!IsWhole(command)) verdict.mistakes.push_back("damaged: " + line);
  });
}

void Judge(const Key& key, const std::string& told, int executed, CommandVerdict& verdict) {
  const bool is_unknown = told == "given" || told == "outcome unknown" || told == "failed";
  const bool is_done = told == "done";
  ++verdict.given;
  ++(is_unknown ? verdict.unknown : is_done ? verdict.done : verdict.refused);
  if (is_unknown && executed == 1) ++verdict.unknown_and_executed;
  const bool is_right = is_unknown ? executed <= 1 : executed == (is_done ? 1 : 0);
  if (is_right) return;
  verdict.mistakes.push_back(NameOf(key) + " ('" + told + "') was executed " +
                             std::to_string(executed) + " times");
}

}  // namespace

CommandVerdict CheckCommands(const fs::path& folder) {
  CommandVerdict verdict;
  std::map<Key, std::string> given;
  std::map<Key, int> executed;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (name.starts_with("given-")) given.merge(ReadGiven(entry.path()));
    if (name.starts_with("executed-")) ReadExecuted(entry.path(), executed, verdict);
  }
  for (const auto& [key, told] : given) {
    const auto node = executed.extract(key);
    Judge(key, told, node ? node.mapped() : 0, verdict);
  }
  for (const auto& [key, times] : executed) {
    verdict.mistakes.push_back(NameOf(key) + " was executed, and never given");
  }
  return verdict;
}

std::string ToString(const CommandVerdict& verdict) {
  return std::to_string(verdict.given) + " commands: " + std::to_string(verdict.done) + " done, " +
         std::to_string(verdict.refused) + " refused, " + std::to_string(verdict.unknown) +
         " unknown (" + std::to_string(verdict.unknown_and_executed) + " of them executed), " +
         std::to_string(verdict.mistakes.size()) + " contradicted";
}

}  // namespace faults
