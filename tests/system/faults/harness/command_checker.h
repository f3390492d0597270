#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace faults {

/// The result of comparing the journals of clients with the journals of ledgers. A command must be
/// executed exactly once if its client reports it as done, never if it was refused, and at most
/// once if its outcome is unknown. A ledger must execute only commands that a client has sent.
struct CommandVerdict {
  std::size_t given = 0;
  std::size_t done = 0;
  std::size_t refused = 0;
  std::size_t unknown = 0;
  std::size_t unknown_and_executed = 0;
  std::vector<std::string> mistakes;  ///< violations of these rules
};

CommandVerdict CheckCommands(const std::filesystem::path& folder);

/// Returns a line for the output of a test: "1234 commands: 1200 done, ..."
std::string ToString(const CommandVerdict& verdict);

}  // namespace faults
