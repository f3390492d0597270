#pragma once

#include <components/host_monitor/host_payloads.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Parses the system files of Linux in /proc and /sys. Malformed lines are skipped; a missing
/// number is 0.
namespace host {

/// Clock ticks since the machine started.
struct CpuTicks {
  std::uint64_t busy = 0;
  std::uint64_t all = 0;
};

struct CpuCounters {
  CpuTicks total;
  std::vector<CpuTicks> cores;  ///< by core number; zeros for a core that is switched off
};

/// Bytes since the machine started, or since a device appeared.
struct DiskCounters {
  std::uint64_t read = 0;
  std::uint64_t written = 0;
};

struct NetworkCounters {
  std::uint64_t received = 0;
  std::uint64_t sent = 0;
  std::uint64_t loopback = 0;
};

/// Parses /proc/stat.
[[nodiscard]] CpuCounters ParseCpu(std::string_view text);

/// Parses /proc/meminfo.
[[nodiscard]] Memory ParseMemory(std::string_view text);

/// Parses /proc/diskstats. Returns the sum over whole disks, without partitions and without devices
/// that consist of disks or memory (loop, ram, dm, md).
[[nodiscard]] DiskCounters ParseDisks(std::string_view text);

/// Parses /proc/net/dev. Returns the sum over external interfaces, and the loopback traffic. Leaves
/// out bridges, tunnels within the machine, and interfaces that consist of other interfaces, so
/// that no traffic is counted twice.
[[nodiscard]] NetworkCounters ParseNetwork(std::string_view text);

/// Parses a file temp or temp*_input of /sys, which has thousandths of °C. Empty if the text is not
/// a number or not a plausible temperature.
[[nodiscard]] std::optional<double> ParseTemperature(std::string_view text);

}  // namespace host
