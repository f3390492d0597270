#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tendon::os {

[[nodiscard]] std::int64_t ProcessId() noexcept;

/// The resources that this process uses.
struct Usage {
  std::chrono::nanoseconds cpu_time{0};  ///< of all threads, since the start of the process
  std::uint64_t memory = 0;              ///< resident bytes; 0 if unknown
};
/// Returns the usage of this process. Takes some microseconds.
[[nodiscard]] Usage OwnUsage();

/// True if the effective user is root.
[[nodiscard]] bool RunsAsRoot() noexcept;

[[nodiscard]] std::string HostName();

/// Returns the user and the machine of this process: "anna@desk". Asks the kernel, not the
/// environment. If the user has no name, returns the user's number instead.
[[nodiscard]] std::string UserAtHost();

/// 64 unpredictable random bits from the kernel.
[[nodiscard]] std::uint64_t RandomNumber();

/// The user's folder for sockets and cookies, mode 0700; created if missing.
[[nodiscard]] std::filesystem::path RuntimeFolder();

/// The user's folder for data that survives a restart, such as history; created if missing.
[[nodiscard]] std::filesystem::path StateFolder();

/// The folder of this program.
[[nodiscard]] std::filesystem::path ProgramFolder();

/// Replaces this process by another program, which is searched in $PATH. Its address space is
/// limited to `most_memory` bytes. Returns only if the program cannot be run.
void BecomeProgram(const std::vector<std::string>& words, std::size_t most_memory);

}  // namespace tendon::os
