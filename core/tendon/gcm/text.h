#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/manager/component_description.h>
#include <tendon/middleware/frame.h>
#include <tendon/process/version_messages.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tendon {

/// The object of a request to a GCM, for the audit log: "start robot/arm". The body is untrusted
/// and may be malformed; empty if there is no text.
[[nodiscard]] std::string AuditObject(MessageType type, std::span<const std::byte> body);

/// The largest age of a value that is shown as current; members report every second.
inline constexpr std::chrono::seconds kFreshHealth(3);

/// The last health report of a process, of any age; null if there is none.
[[nodiscard]] const message::ProcessHealth* LastHealth(const message::SystemHealth& health,
                                                       const ProcessDescription& process);

/// The last health report if it is current; null if the process is not alive, or has not reported
/// within kFreshHealth.
[[nodiscard]] const message::ProcessHealth* FindHealth(const message::SystemHealth& health,
                                                       const ProcessDescription& process);

/// "0.1 ms".
[[nodiscard]] std::string MillisecondsText(std::chrono::nanoseconds time);

// These return "-" for null, or if the value is not known yet.

/// "12.5 %" of one core.
[[nodiscard]] std::string CpuText(const message::ProcessHealth* health);
/// "34.1 MiB".
[[nodiscard]] std::string MemoryText(const message::ProcessHealth* health);
/// "0.0 ms off (+-0.1 ms)".
[[nodiscard]] std::string ClockText(const message::ProcessHealth* health);

/// Describes the loaded version of a plug-in: "/opt/robot/arm.so of 2025-11-21 15:40:03".
[[nodiscard]] std::string PluginText(const PluginDescription& plugin);

/// Describes the change of its file since then: "written again at 2025-11-21 15:50:10", "gone";
/// empty if the file is unchanged.
[[nodiscard]] std::string PluginChangeText(const PluginDescription& plugin);

/// A plug-in whose file has changed.
struct OutdatedPlugin {
  /// "process 'robot' runs /opt/robot/arm.so of 2025-11-21 15:40:03; the file was written again at
  /// 2025-11-21 15:50:10"
  std::string finding;
  std::string remedy;  ///< "restart the process to use it"
};

/// Nothing if the file is unchanged.
[[nodiscard]] std::optional<OutdatedPlugin> FindOutdatedPlugin(const std::string& process,
                                                               const PluginDescription& plugin);

/// Finding and remedy in one sentence: "FINDING: REMEDY". Empty if the file is unchanged.
[[nodiscard]] std::string OutdatedPluginText(const std::string& process,
                                             const PluginDescription& plugin);

/// "step 7 (connect a/b/C d/e/F, by gcm connect at 2025-11-21 15:40:03)".
[[nodiscard]] std::string WholeText(const message::HistoryEntry& step);

/// "noise 0.001 -> 0.5, bandwidth default -> 80": the changes of a "configure" step; empty for
/// other steps.
[[nodiscard]] std::string ChangesText(const message::HistoryEntry& step);

/// True if the step concerns the lifecycle of a component or of a started process.
[[nodiscard]] bool IsLifecycleStep(const message::HistoryEntry& step);
[[nodiscard]] bool IsProcessStep(const message::HistoryEntry& step);

/// The process that executed the step, and that would undo it. If the step started a process, the
/// started process.
[[nodiscard]] const std::string& ProcessOf(const message::HistoryEntry& step);

/// "version 0.4.0, protocol 10".
[[nodiscard]] std::string VersionText(const message::ProgramVersion& version);

/// The result of CompareVersion().
struct VersionReport {
  std::string text;  ///< "version 0.3.0, protocol 10, but this program has another version"
  bool is_own = false;
};
/// Compares the version that a program has reported with `own`. The text also covers a program that
/// did not report one.
[[nodiscard]] VersionReport CompareVersion(const Result<message::ProgramVersion>& told,
                                           const message::ProgramVersion& own);

/// The time in nanoseconds since 1970. It may jump, so use it for display only; for decisions, use
/// a Clock.
[[nodiscard]] std::int64_t WallTime();

/// "2025-11-21 15:40:03", in local time.
[[nodiscard]] std::string WallTimeText(std::int64_t nanoseconds);

/// The same with milliseconds: "2025-11-21 15:40:03.250".
[[nodiscard]] std::string FineWallTimeText(std::int64_t nanoseconds);

}  // namespace tendon
