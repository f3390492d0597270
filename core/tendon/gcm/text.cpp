#include <tendon/gcm/text.h>

#include <tendon/base/text.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/gcm/step_history.h>
#include <tendon/middleware/body.h>
#include <tendon/payload/json/strict_json.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <ctime>
#include <nlohmann/json.hpp>
#include <set>

namespace tendon {
namespace {

std::string ObjectOf(const message::LifecycleOrder& order) {
  const std::string& object = order.component.empty() ? order.library : order.component;
  const std::string class_name = order.class_name.empty() ? "" : " of " + order.class_name;
  return std::string(ToString(order.verb)) + " " + order.process + "/" + object + class_name;
}

constexpr const char* kUnknown = "-";

std::string OneDigit(double value) {
  std::array<char, 320> text{};
  const auto end = std::to_chars(text.begin(), text.end(), value, std::chars_format::fixed, 1).ptr;
  return {text.data(), end};
}

std::string ReachSeconds(std::chrono::nanoseconds time) {
  return OneDigit(std::chrono::duration<double>(time).count()) + " s";
}

using OrderedJson = nlohmann::ordered_json;

OrderedJson ObjectOf(const std::string& configuration) {
  auto object = JsonOrText(configuration);
  return object.is_object() ? object : OrderedJson::object();
}

std::string ValueOf(const OrderedJson& object, const std::string& key) {
  constexpr std::size_t kMax = 80;
  return object.contains(key) ? Printable(object.at(key).dump(), kMax) : "default";
}

}  // namespace

std::string AuditObject(MessageType type, std::span<const std::byte> body) {
  if (type == message::kForget) {
    const auto forget = DecodeBody<message::ForgetProcess>(body);
    return forget ? forget->process : std::string();
  }
  if (type == message::kSetLogLevel) {
    const auto order = DecodeBody<message::SetLogLevel>(body);
    return order ? order->process : std::string();
  }
  if (type == message::kLifecycleOrder) {
    const auto order = DecodeBody<message::LifecycleOrder>(body);
    return order ? ObjectOf(*order) : std::string();
  }
  if (type == message::kProcess) {
    const auto order = DecodeBody<message::ProcessOrder>(body);
    return order ? std::string(ToString(order->verb)) + " " + order->process : std::string();
  }
  const bool has_ends =
      type == message::kConnect || type == message::kReplace || type == message::kDisconnect;
  const auto ends =
      has_ends ? DecodeBody<message::ConnectionEnds>(body) : Result(message::ConnectionEnds());
  if (!has_ends || !ends) return {};
  const bool has_provided = type != message::kDisconnect;
  return ToString(ends->required) + (has_provided ? " " + ToString(ends->provided) : "");
}

const message::ProcessHealth* LastHealth(const message::SystemHealth& health,
                                         const ProcessDescription& process) {
  const auto found =
      std::ranges::find(health.processes, process.name, &message::ProcessHealth::process);
  const bool is_known = found != health.processes.end() && found->instance == process.instance;
  return is_known ? &*found : nullptr;
}

const message::ProcessHealth* FindHealth(const message::SystemHealth& health,
                                         const ProcessDescription& process) {
  if (process.state != ProcessState::kAlive) return nullptr;
  const auto* const last = LastHealth(health, process);
  return last != nullptr && last->age <= kFreshHealth ? last : nullptr;
}

std::string CpuText(const message::ProcessHealth* health) {
  constexpr double kPercent = 100.0;
  return health == nullptr || health->cpu < 0.0 ? kUnknown
                                                : OneDigit(health->cpu * kPercent) + " %";
}

std::string MemoryText(const message::ProcessHealth* health) {
  constexpr double kMiB = 1024.0 * 1024.0;
  if (health == nullptr || health->memory == 0) return kUnknown;
  return OneDigit(static_cast<double>(health->memory) / kMiB) + " MiB";
}

std::string HistoryText(const message::ProcessHistoryState& history) {
  constexpr double kMiB = 1024.0 * 1024.0;
  if (history.limit == 0) return "off";
  const auto missed = [](std::uint64_t count, const char* one, const char* many) {
    return count == 0 ? std::string() : ", " + Counted(count, one, many) + " missed";
  };
  return "last " + ReachSeconds(history.reach) + ", " +
         OneDigit(static_cast<double>(history.memory) / kMiB) + " of " +
         OneDigit(static_cast<double>(history.limit) / kMiB) + " MiB" +
         missed(history.missed_rows, "row", "rows") +
         missed(history.missed_events, "event", "events");
}

std::string HistoryReachText(const message::ProcessHistoryState& history,
                             std::chrono::nanoseconds wanted) {
  if (history.limit == 0) {
    return "only the rows in its state tables: its history is off (--history-memory)";
  }
  if (history.reach >= wanted) return {};
  const std::string reach = ReachSeconds(history.reach) + ": ";
  if (history.reach >= history.age) return reach + "it has not been running longer";
  if (history.reach >= history.span) return reach + "it is set to keep no more";
  return reach + "its history is full (" + HistoryText(history) + "; see --history-memory)";
}

std::string MillisecondsText(std::chrono::nanoseconds time) {
  constexpr double kMillisecond = 1e6;
  return OneDigit(static_cast<double>(time.count()) / kMillisecond) + " ms";
}

std::string ClockText(const message::ProcessHealth* health) {
  if (health == nullptr || health->clock_uncertainty < std::chrono::nanoseconds(0)) return kUnknown;
  return MillisecondsText(health->clock_offset) + " off (+-" +
         MillisecondsText(health->clock_uncertainty) + ")";
}

std::string PluginText(const PluginDescription& plugin) {
  return plugin.file + " of " + WallTimeText(plugin.written);
}

std::string PluginChangeText(const PluginDescription& plugin) {
  if (plugin.state == PluginState::kCurrent) return "";
  if (plugin.state == PluginState::kGone) return "gone";
  return "written again at " + WallTimeText(plugin.written_now);
}

std::optional<OutdatedPlugin> FindOutdatedPlugin(const std::string& process,
                                                 const PluginDescription& plugin) {
  if (plugin.state == PluginState::kCurrent) return std::nullopt;
  const bool is_gone = plugin.state == PluginState::kGone;
  return OutdatedPlugin{
      .finding = "process '" + process + "' runs " + PluginText(plugin) + "; the file " +
                 (is_gone ? "is missing" : "was " + PluginChangeText(plugin)),
      .remedy = is_gone ? "restore the plug-in file before you restart the process"
                        : "restart the process to use the new file"};
}

std::string OutdatedPluginText(const std::string& process, const PluginDescription& plugin) {
  const auto old = FindOutdatedPlugin(process, plugin);
  return old ? old->finding + ": " + old->remedy : "";
}

std::string WholeText(const message::HistoryEntry& step) {
  return "step " + std::to_string(step.id) + " (" + ToString(step) + ", by " + step.who + " at " +
         WallTimeText(step.when) + ")";
}

std::string ChangesText(const message::HistoryEntry& step) {
  if (step.verb != ToString(LifecycleVerb::kConfigure)) return {};
  const OrderedJson former = ObjectOf(step.lifecycle.former);
  const OrderedJson now = ObjectOf(step.lifecycle.configuration);
  std::set<std::string> keys;
  for (const auto& [key, value] : former.items()) keys.insert(key);
  for (const auto& [key, value] : now.items()) keys.insert(key);
  std::string text;
  for (const std::string& key : keys) {
    const std::string before = ValueOf(former, key);
    const std::string after = ValueOf(now, key);
    if (before == after) continue;
    text += (text.empty() ? "" : ", ") + Printable(key, 64) + " " + before + " -> " + after;
  }
  return text;
}

bool IsLifecycleStep(const message::HistoryEntry& step) { return !step.lifecycle.process.empty(); }

bool IsProcessStep(const message::HistoryEntry& step) {
  return IsLifecycleStep(step) && step.lifecycle.component.empty();
}

const std::string& ProcessOf(const message::HistoryEntry& step) {
  return IsLifecycleStep(step) ? step.lifecycle.process : step.ends.required.process;
}

std::string VersionText(const message::ProgramVersion& version) {
  return "version " + version.release + ", protocol " + std::to_string(version.protocol);
}

VersionReport CompareVersion(const Result<message::ProgramVersion>& reported,
                             const message::ProgramVersion& own) {
  if (!reported) return {.text = "of an unknown version (" + reported.error().message + ")"};
  const bool is_own = reported->release == own.release && reported->protocol == own.protocol;
  return {.text = VersionText(*reported) + (is_own ? "" : ", but this program has another version"),
          .is_own = is_own};
}

std::int64_t WallTime() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

std::string WallTimeText(std::int64_t nanoseconds) {
  const std::chrono::nanoseconds since(nanoseconds);
  const std::time_t seconds = std::chrono::duration_cast<std::chrono::seconds>(since).count();
  std::tm parts{};
  localtime_r(&seconds, &parts);
  std::array<char, 32> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S", &parts);
  return {text.data(), length};
}

std::string FineWallTimeText(std::int64_t nanoseconds) {
  constexpr std::int64_t kMillisecond = 1'000'000;
  // Positive, even before 1970.
  const std::int64_t below_second = (nanoseconds / kMillisecond % 1000 + 1000) % 1000;
  std::string milliseconds = std::to_string(1000 + below_second);
  milliseconds.front() = '.';
  return WallTimeText(nanoseconds) + milliseconds;
}

}  // namespace tendon
