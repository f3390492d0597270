#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace faults {

/// What the journals of clients and ledgers say of all commands: one whose client was told that it
/// is done was executed exactly once; one that was refused not at all; one of unknown end at most
/// once; and nothing else was executed.
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
