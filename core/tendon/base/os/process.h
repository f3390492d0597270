#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tendon::os {

[[nodiscard]] std::int64_t ProcessId() noexcept;

/// The resources that this process uses.
struct Usage {
  std::chrono::nanoseconds cpu_time{0};  ///< of all its threads, since it was started
  std::uint64_t memory = 0;              ///< resident bytes; 0 if unknown
};
/// Takes some microseconds.
[[nodiscard]] Usage OwnUsage();

/// True if this process may do anything on this machine.
[[nodiscard]] bool RunsAsRoot() noexcept;

[[nodiscard]] std::string HostName();

/// User and machine of this process: "anna@desk". From the kernel, not from the environment; the
/// user's number if there is no name.
[[nodiscard]] std::string UserAtHost();

/// 64 random bits from the kernel, which nobody can guess.
[[nodiscard]] std::uint64_t RandomNumber();

/// The user's folder for sockets and cookies, mode 0700; created if missing.
[[nodiscard]] std::filesystem::path RuntimeFolder();

/// The user's folder for data that survives a restart, such as history; created if missing.
[[nodiscard]] std::filesystem::path StateFolder();

/// The folder of this program.
[[nodiscard]] std::filesystem::path ProgramFolder();

/// Replaces this process by another program, found in $PATH, with at most `most_memory` bytes of
/// addresses. Returns only if there is none.
void BecomeProgram(const std::vector<std::string>& words, std::size_t most_memory);

}  // namespace tendon::os
