#include <components/host_monitor/host_text.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

namespace host {
namespace {

constexpr std::size_t kMaxCores = 4096;
constexpr double kKibInMib = 1024.0;

/// Removes the next line from the front of `text` and returns it.
std::string_view TakeLine(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

/// Removes the next word from the front of `line` and returns it; empty at the end.
std::string_view TakeWord(std::string_view& line) {
  constexpr std::string_view kSpace = " \t\r";
  line.remove_prefix(std::min(line.find_first_not_of(kSpace), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(kSpace));
  line.remove_prefix(word.size());
  return word;
}

template <typename T>
std::optional<T> ToNumber(std::string_view word) {
  T number{};
  const char* const end = word.data() + word.size();
  const auto [last, code] = std::from_chars(word.data(), end, number);
  if (code != std::errc{} || last != end) return std::nullopt;
  return number;
}

std::uint64_t TakeNumber(std::string_view& line) {
  return ToNumber<std::uint64_t>(TakeWord(line)).value_or(0);
}

bool StartsWithAny(std::string_view name, std::initializer_list<std::string_view> beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [name](std::string_view one) { return name.starts_with(one); });
}

/// True for "sda1" and "sda", or "nvme0n1p2" and "nvme0n1".
bool IsPartitionOf(std::string_view name, std::string_view disk) {
  if (disk.empty() || !name.starts_with(disk)) return false;
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::string_view rest = name.substr(disk.size());
  if (is_digit(disk.back())) {
    if (!rest.starts_with('p')) return false;
    rest.remove_prefix(1);
  }
  return !rest.empty() && std::all_of(rest.begin(), rest.end(), is_digit);
}

}  // namespace

CpuCounters ParseCpu(std::string_view text) {
  CpuCounters counters;
  while (!text.empty()) {
    std::string_view line = TakeLine(text);
    std::string_view name = TakeWord(line);
    if (!name.starts_with("cpu")) continue;
    name.remove_prefix(3);
    // The columns are user nice system idle iowait irq softirq steal; `user` already includes
    // guests.
    std::array<std::uint64_t, 8> ticks{};
    CpuTicks sum;
    for (std::uint64_t& one : ticks) {
      one = TakeNumber(line);
      sum.all += one;
    }
    sum.busy = sum.all - ticks[3] - ticks[4];
    if (name.empty()) {
      counters.total = sum;
    } else if (const auto core = ToNumber<std::size_t>(name); core && *core < kMaxCores) {
      counters.cores.resize(std::max(counters.cores.size(), *core + 1));
      counters.cores[*core] = sum;
    }
  }
  return counters;
}

Memory ParseMemory(std::string_view text) {
  std::map<std::string_view, double> lines;  // MiB
  while (!text.empty()) {
    std::string_view line = TakeLine(text);
    const std::string_view name = TakeWord(line);
    lines[name] = static_cast<double>(TakeNumber(line)) / kKibInMib;
  }
  const bool knows_available = lines.contains("MemAvailable:");  // since Linux 3.14
  const double available = knows_available
                               ? lines["MemAvailable:"]
                               : lines["MemFree:"] + lines["Buffers:"] + lines["Cached:"];
  return {.used = std::max(0.0, lines["MemTotal:"] - available),
          .total = lines["MemTotal:"],
          .swap = std::max(0.0, lines["SwapTotal:"] - lines["SwapFree:"])};
}

DiskCounters ParseDisks(std::string_view text) {
  constexpr std::uint64_t kSector = 512;  // bytes, independent of the disk's own sector size
  std::map<std::string_view, DiskCounters> disks;
  while (!text.empty()) {
    std::string_view line = TakeLine(text);
    TakeWord(line);  // major and minor number
    TakeWord(line);
    const std::string_view name = TakeWord(line);
    if (name.empty() || StartsWithAny(name, {"loop", "ram", "zram", "dm-", "md"})) continue;
    TakeWord(line);  // reads completed, reads merged
    TakeWord(line);
    DiskCounters& disk = disks[name];
    disk.read = TakeNumber(line) * kSector;
    TakeWord(line);  // ms reading, writes completed, writes merged
    TakeWord(line);
    TakeWord(line);
    disk.written = TakeNumber(line) * kSector;
  }
  DiskCounters sum;
  for (const auto& disk : disks) {
    const bool is_partition = std::any_of(disks.begin(), disks.end(), [&disk](const auto& other) {
      return IsPartitionOf(disk.first, other.first);
    });
    if (is_partition) continue;
    sum.read += disk.second.read;
    sum.written += disk.second.written;
  }
  return sum;
}

NetworkCounters ParseNetwork(std::string_view text) {
  constexpr int kBetween = 7;  // number of columns between received and sent bytes
  NetworkCounters sum;
  while (!text.empty()) {
    std::string_view line = TakeLine(text);
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) continue;
    std::string_view before = line.substr(0, colon);
    const std::string_view name = TakeWord(before);
    line.remove_prefix(colon + 1);
    const std::uint64_t received = TakeNumber(line);
    for (int column = 0; column < kBetween; ++column) TakeWord(line);
    const std::uint64_t sent = TakeNumber(line);
    if (name == "lo") {
      sum.loopback += sent;
    } else if (!StartsWithAny(name, {"veth", "docker", "br-", "virbr", "ifb", "dummy", "bond"})) {
      sum.received += received;
      sum.sent += sent;
    }
  }
  return sum;
}

std::optional<double> ParseTemperature(std::string_view text) {
  constexpr double kColdest = -100.0;  // °C; missing sensors often report -273 or 65535
  constexpr double kHottest = 250.0;   // °C
  std::string_view line = TakeLine(text);
  const auto thousandths = ToNumber<std::int64_t>(TakeWord(line));
  if (!thousandths) return std::nullopt;
  const double temperature = static_cast<double>(*thousandths) / 1000.0;
  if (temperature < kColdest || temperature > kHottest) return std::nullopt;
  return temperature;
}

}  // namespace host
