#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/manager/component_description.h>
#include <tendon/middleware/frame.h>
#include <tendon/process/history/history_messages.h>
#include <tendon/process/version_messages.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tendon {

/// Returns the object of a request to a GCM, for the audit log: "start robot/arm". Returns an empty
/// text for other types of requests. The body is untrusted; a malformed body also gives an empty
/// text.
[[nodiscard]] std::string AuditObject(MessageType type, std::span<const std::byte> body);

/// The largest age of a health report that is shown as current. Members report every second.
inline constexpr std::chrono::seconds kFreshHealth(3);

/// Returns the last health report of a process, of any age; null if it has never reported.
[[nodiscard]] const message::ProcessHealth* LastHealth(const message::SystemHealth& health,
                                                       const ProcessDescription& process);

/// Returns the last health report of a process if it is current; null if the process is not alive,
/// or has not reported within kFreshHealth.
[[nodiscard]] const message::ProcessHealth* FindHealth(const message::SystemHealth& health,
                                                       const ProcessDescription& process);

/// Returns a time as text: "0.1 ms".
[[nodiscard]] std::string MillisecondsText(std::chrono::nanoseconds time);

// The next three functions return "-" if `health` is null or the value is not known yet.

/// The CPU load: "12.5 %" of one core.
[[nodiscard]] std::string CpuText(const message::ProcessHealth* health);
/// The memory: "34.1 MiB".
[[nodiscard]] std::string MemoryText(const message::ProcessHealth* health);
/// The offset of the clock: "0.0 ms off (+-0.1 ms)".
[[nodiscard]] std::string ClockText(const message::ProcessHealth* health);

/// Describes the loaded version of a plug-in: "/opt/robot/arm.so of 2025-11-21 15:40:03".
[[nodiscard]] std::string PluginText(const PluginDescription& plugin);

/// Describes how the file of a plug-in has changed since the plug-in was loaded: "written again at
/// 2025-11-21 15:50:10", "gone"; empty if the file is unchanged.
[[nodiscard]] std::string PluginChangeText(const PluginDescription& plugin);

/// A plug-in whose file has changed.
struct OutdatedPlugin {
  /// "process 'robot' runs /opt/robot/arm.so of 2025-11-21 15:40:03; the file was written again at
  /// 2025-11-21 15:50:10"
  std::string finding;
  std::string remedy;  ///< "restart the process to use the new file"
};

/// Returns nothing if the file of the plug-in is unchanged.
[[nodiscard]] std::optional<OutdatedPlugin> FindOutdatedPlugin(const std::string& process,
                                                               const PluginDescription& plugin);

/// Returns finding and remedy as one text: "FINDING: REMEDY". Returns an empty text if the file is
/// unchanged.
[[nodiscard]] std::string OutdatedPluginText(const std::string& process,
                                             const PluginDescription& plugin);

/// Returns a step with number, program and time: "step 7 (connect a/b/C d/e/F, by gcm connect at
/// 2025-11-21 15:40:03)".
[[nodiscard]] std::string WholeText(const message::HistoryEntry& step);

/// The changes of a "configure" step, "noise 0.001 -> 0.5, bandwidth default -> 80"; empty for
/// other steps.
[[nodiscard]] std::string ChangesText(const message::HistoryEntry& step);

/// IsLifecycleStep() returns true for a step that changes the lifecycle of a component, or a
/// process that the GCM has started. IsProcessStep() returns true only for a step that changes a
/// process.
[[nodiscard]] bool IsLifecycleStep(const message::HistoryEntry& step);
[[nodiscard]] bool IsProcessStep(const message::HistoryEntry& step);

/// Returns the process that executed the step and would undo it. If the step started a process,
/// returns this process.
[[nodiscard]] const std::string& ProcessOf(const message::HistoryEntry& step);

/// Describes the history that a process keeps: "last 30.0 s, 12.3 of 32.0 MiB", or "off". The
/// text also has the numbers of missed rows and events, if any.
[[nodiscard]] std::string HistoryText(const message::ProcessHistoryState& history);
/// Returns the length of a process's history, and why it is not longer, for example "12.3 s: it has
/// not been running longer". Returns an empty string if the history covers `wanted`.
[[nodiscard]] std::string HistoryReachText(const message::ProcessHistoryState& history,
                                           std::chrono::nanoseconds wanted);

/// Returns a version as text: "version 0.4.0, protocol 11".
[[nodiscard]] std::string VersionText(const message::ProgramVersion& version);

/// The result of CompareVersion().
struct VersionReport {
  std::string text;  ///< "version 0.3.0, protocol 11, but this program has another version"
  bool is_own = false;
};
/// Compares the version that a program has reported with `own`. If the program has not answered,
/// the text says why its version is unknown.
[[nodiscard]] VersionReport CompareVersion(const Result<message::ProgramVersion>& reported,
                                           const message::ProgramVersion& own);

/// Returns the time of the system clock in nanoseconds since 1970. This time may jump, so use it
/// for display only; for decisions, use a Clock.
[[nodiscard]] std::int64_t WallTime();

/// Returns a time as text, in local time: "2025-11-21 15:40:03".
[[nodiscard]] std::string WallTimeText(std::int64_t nanoseconds);

/// Like WallTimeText(), but with milliseconds: "2025-11-21 15:40:03.250".
[[nodiscard]] std::string FineWallTimeText(std::int64_t nanoseconds);

}  // namespace tendon
