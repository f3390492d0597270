#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tendon::os {

[[nodiscard]] std::int64_t ProcessId() noexcept;

/// What this process takes of its machine.
struct Usage {
  std::chrono::nanoseconds cpu_time{0};  ///< of all its threads, since it was started
  std::uint64_t memory = 0;              ///< bytes that are resident; 0 where nobody tells
};
/// Takes some microseconds.
[[nodiscard]] Usage OwnUsage();

/// Whether this process may do anything on this machine.
[[nodiscard]] bool RunsAsRoot() noexcept;

[[nodiscard]] std::string HostName();

/// Whose process this is, and on which machine: "anna@desk". By the kernel's word, not by that of
/// the environment; the user's number where it has no name.
[[nodiscard]] std::string UserAtHost();

/// 64 bits that nobody can guess, from the kernel.
[[nodiscard]] std::uint64_t RandomNumber();

/// The user's folder for sockets and cookies, mode 0700; made when missing.
[[nodiscard]] std::filesystem::path RuntimeFolder();

/// The user's folder for what survives a restart, such as history; made when missing.
[[nodiscard]] std::filesystem::path StateFolder();

/// Where this program lies, without its own name.
[[nodiscard]] std::filesystem::path ProgramFolder();

/// This process goes on as another program, which is looked for in $PATH, and gets no more than
/// `most_memory` bytes of addresses. Returns only where there is none.
void BecomeProgram(const std::vector<std::string>& words, std::size_t most_memory);

}  // namespace tendon::os
