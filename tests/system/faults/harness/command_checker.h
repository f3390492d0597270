#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace faults {

/// Compares the journals of clients and ledgers: a command that was reported as done was executed
/// exactly once, a refused one never, one with an unknown outcome at most once, and no other
/// command was executed.
struct CommandVerdict {
  std::size_t given = 0;
  std::size_t done = 0;
  std::size_t refused = 0;
  std::size_t unknown = 0;
  std::size_t unknown_and_executed = 0;
  std::vector<std::string> mistakes;  ///< what contradicts that
};

CommandVerdict CheckCommands(const std::filesystem::path& folder);

/// For people: "1234 commands: 1200 done, ..."
std::string ToString(const CommandVerdict& verdict);

}  // namespace faults
