#pragma once

#include <components/host_monitor/host_payloads.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Reads the texts that Linux gives about itself, in /proc and /sys. Lines that make no sense are
/// passed over; a number that is missing is 0.
namespace host {

/// Clock ticks since the machine was started.
struct CpuTicks {
  std::uint64_t busy = 0;
  std::uint64_t all = 0;
};

struct CpuCounters {
  CpuTicks total;
  std::vector<CpuTicks> cores;  ///< by their numbers; one that is switched off has zeros
};

/// Bytes since the machine was started, or since a device appeared.
struct DiskCounters {
  std::uint64_t read = 0;
  std::uint64_t written = 0;
};

struct NetworkCounters {
  std::uint64_t received = 0;
  std::uint64_t sent = 0;
  std::uint64_t loopback = 0;
};

/// /proc/stat
[[nodiscard]] CpuCounters ParseCpu(std::string_view text);

/// /proc/meminfo
[[nodiscard]] Memory ParseMemory(std::string_view text);

/// /proc/diskstats: the sum over whole disks, not over their partitions, nor over what is made of
/// disks or memory (loop, ram, dm, md).
[[nodiscard]] DiskCounters ParseDisks(std::string_view text);

/// /proc/net/dev: the sum over interfaces that lead out, and the loopback. Bridges, tunnels within
/// the machine and interfaces made of others are left out, so that nothing counts twice.
[[nodiscard]] NetworkCounters ParseNetwork(std::string_view text);

/// A file temp or temp*_input of /sys: thousandths of °C. Nothing when it is no number or no
/// temperature.
[[nodiscard]] std::optional<double> ParseTemperature(std::string_view text);

}  // namespace host
