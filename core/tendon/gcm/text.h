#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/diagnosis.h>
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

/// The last report of a process in the catalogue, of any age; null if there is none.
[[nodiscard]] const message::ProcessHealth* LastHealth(const message::SystemHealth& health,
                                                       const ProcessDescription& process);

/// The same if it is current; null if the process is not alive or has not reported recently.
[[nodiscard]] const message::ProcessHealth* FindHealth(const message::SystemHealth& health,
                                                       const ProcessDescription& process);

// These return "-" for null, or if the value is not known yet.

/// "12.5 %" of one core.
[[nodiscard]] std::string CpuText(const message::ProcessHealth* health);
/// "34.1 MiB".
[[nodiscard]] std::string MemoryText(const message::ProcessHealth* health);
/// "0.0 ms off (+-0.1 ms)".
[[nodiscard]] std::string ClockText(const message::ProcessHealth* health);

/// True if the process of the required interface still tries to make the inactive connection.
[[nodiscard]] bool IsKept(const Diagnosis& diagnosis);

/// What is left of an inactive connection, one line for each process that was asked: "left over:
/// nothing in robot", "kept: desk makes it as soon as it can". The text is also correct if nobody
/// has tried to make the connection.
[[nodiscard]] std::vector<std::string> LeftoverTexts(const Diagnosis& diagnosis);

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

/// True if the step concerns the life cycle of a component or of a started process.
[[nodiscard]] bool IsOfLife(const message::HistoryEntry& step);
[[nodiscard]] bool IsOfProcess(const message::HistoryEntry& step);

/// The process that executed the step, and would undo it. For the start of a process, that process
/// itself.
[[nodiscard]] const std::string& ProcessOf(const message::HistoryEntry& step);

/// "version 0.4.0, protocol 10".
[[nodiscard]] std::string VersionText(const message::ProgramVersion& version);

/// A text about the version that a program reported, or about its absence, and whether it equals
/// `own`.
struct VersionReport {
  std::string text;  ///< "version 0.3.0, protocol 10, which is not that of this program"
  bool is_own = false;
};
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
