#pragma once

#include <tendon/base/name.h>
#include <tendon/interface/interface_description.h>
#include <tendon/payload/shared_list.h>
#include <tendon/task/component_state.h>
#include <tendon/task/thread_options.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// One column of a state table: a payload with a name.
struct ColumnDescription {
  std::string name;
  std::string type;
  Fingerprint fingerprint;

  bool operator==(const ColumnDescription&) const = default;
};

/// The description of a state table. A provided interface with the name `state` (for the table
/// "state") or `state-NAME` gives access to the table, with one read command per column.
struct TableDescription {
  std::string name;          ///< the provided interface of the table is "state" or "state-NAME"
  std::uint64_t length = 0;  ///< number of rows that are kept
  std::vector<ColumnDescription> columns;

  bool operator==(const TableDescription&) const = default;
};

/// Whether the file of a plug-in has changed since the plug-in was loaded.
enum class PluginState : std::int32_t {
  kCurrent,  ///< the file contains the loaded version
  kChanged,  ///< the file contains another version; only a new process can load it
  kGone,
};

template <>
inline constexpr auto kPayload<PluginState> = DescribeEnum(
    "tendon.PluginState", Enumerator{"current", PluginState::kCurrent},
    Enumerator{"changed", PluginState::kChanged}, Enumerator{"gone", PluginState::kGone});

/// "current", "changed", "gone".
[[nodiscard]] constexpr std::string_view ToString(PluginState state) noexcept {
  return NameOf(state);
}

/// A plug-in that a process has loaded. The process keeps the loaded version, even if the file
/// changes.
struct PluginDescription {
  std::string name;
  std::string file;  ///< path of the file
  /// Time at which the loaded version was written, ns since 1970 (for people).
  std::int64_t written = 0;
  PluginState state = PluginState::kCurrent;
  std::int64_t written_now = 0;  ///< only for kChanged: time at which the file was written again

  bool operator==(const PluginDescription&) const = default;
};

/// The description of a component.
struct ComponentDescription {
  std::string name;
  std::string class_name;
  std::string library;        ///< name of the plug-in; empty if the class is not from a plug-in
  std::string configuration;  ///< JSON, as given to the component; empty if none was given
  ComponentState state = ComponentState::kConstructed;
  std::string fault;  ///< the reason of the fault
  /// Time of the fault, ns since 1970 (for people); 0 if there was no fault.
  std::int64_t fault_time = 0;
  std::string warning;  ///< a problem of an active component: "missed 8 x 10 ms"
  double period = 0.0;  ///< s; 0 if the component has no period
  /// The options of its own thread, as one entry. They are also set while the component runs after
  /// another one. Empty if the component never has a thread of its own.
  std::vector<ThreadOptions> thread{};
  std::string leader{};  ///< the component after which this one runs, or empty
  SharedList<ProvidedDescription> provided;
  SharedList<RequiredDescription> required;
  SharedList<TableDescription> tables;

  bool operator==(const ComponentDescription&) const = default;
};

enum class ConnectionState : std::int32_t {
  kPending,  ///< the peer does not exist yet, or it is faulted
  kActive,
  kFailed,  ///< the peer has refused the connection
};

template <>
inline constexpr auto kPayload<ConnectionState> = DescribeEnum(
    "tendon.ConnectionState", Enumerator{"pending", ConnectionState::kPending},
    Enumerator{"active", ConnectionState::kActive}, Enumerator{"failed", ConnectionState::kFailed});

/// "pending", "active", "failed".
[[nodiscard]] constexpr std::string_view ToString(ConnectionState state) noexcept {
  return NameOf(state);
}

/// A connection. It belongs to the process of its required interface. A required interface has at
/// most one connection.
struct ConnectionDescription {
  std::uint64_t id = 0;  ///< unique within the process of the required side
  InterfaceName required;
  InterfaceName provided;
  ConnectionState state = ConnectionState::kPending;
  std::string reason;  ///< the reason why the connection is pending or failed
  /// The functions whose values are encoded and decoded, because the two ends have different memory
  /// layouts of a type. Such calls are slower and may allocate memory.
  std::vector<std::string> converted{};

  bool operator==(const ConnectionDescription&) const = default;
};

/// Marks a connection as pending because one of its two components, `component`, is faulted.
/// `fault` is Component::fault(), which becomes a part of the reason.
inline void SetEndFaulted(ConnectionDescription& connection, const std::string& component,
                          const std::string& fault) {
  connection.state = ConnectionState::kPending;
  connection.reason = "component '" + component + "' is faulted: " + fault +
                      "; the connection is made again when that component is started";
}

/// Statistics of a connection's calls and events since it was last made.
struct ConnectionCounts {
  std::chrono::nanoseconds age{0};  ///< time since the connection was last made
  /// The last measured round-trip time to the other process; negative if it is unknown or both ends
  /// are in one process.
  std::chrono::nanoseconds round_trip{-1};
  std::uint64_t taken = 0;        ///< calls and events that have left a mailbox
  std::uint64_t capacity = 0;     ///< number of calls that the server's mailbox can hold
  std::uint64_t waiting = 0;      ///< number of calls in the server's mailbox now
  std::uint64_t refused = 0;      ///< calls refused because the server's mailbox was full
  std::uint64_t replaced = 0;     ///< calls replaced by newer calls of the same command
  std::uint64_t lost_events = 0;  ///< events that did not reach the client

  bool operator==(const ConnectionCounts&) const = default;
};

/// The fill level of a component's fullest mailbox.
struct MailboxFill {
  std::uint64_t waiting = 0;   ///< number of calls or events in the mailbox now
  std::uint64_t capacity = 0;  ///< number of calls or events that it can hold; 0 if not connected

  bool operator==(const MailboxFill&) const = default;
};

}  // namespace tendon

template <>
inline constexpr auto tendon::kPayload<tendon::InterfaceName> = tendon::Describe(
    "tendon.InterfaceName", tendon::Field{"process", &tendon::InterfaceName::process},
    tendon::Field{"component", &tendon::InterfaceName::component},
    tendon::Field{"interface", &tendon::InterfaceName::interface});

template <>
inline constexpr auto tendon::kPayload<tendon::ColumnDescription> = tendon::Describe(
    "tendon.ColumnDescription", tendon::Field{"name", &tendon::ColumnDescription::name},
    tendon::Field{"type", &tendon::ColumnDescription::type},
    tendon::Field{"fingerprint", &tendon::ColumnDescription::fingerprint});

template <>
inline constexpr auto tendon::kPayload<tendon::TableDescription> = tendon::Describe(
    "tendon.TableDescription", tendon::Field{"name", &tendon::TableDescription::name},
    tendon::Field{"length", &tendon::TableDescription::length},
    tendon::Field{"columns", &tendon::TableDescription::columns});

template <>
inline constexpr auto tendon::kPayload<tendon::PluginDescription> = tendon::Describe(
    "tendon.PluginDescription", tendon::Field{"name", &tendon::PluginDescription::name},
    tendon::Field{"file", &tendon::PluginDescription::file},
    tendon::Field{"written", &tendon::PluginDescription::written, "ns"},
    tendon::Field{"state", &tendon::PluginDescription::state},
    tendon::Field{"written_now", &tendon::PluginDescription::written_now, "ns"});

template <>
inline constexpr auto tendon::kPayload<tendon::ComponentDescription> = tendon::Describe(
    "tendon.ComponentDescription", tendon::Field{"name", &tendon::ComponentDescription::name},
    tendon::Field{"class_name", &tendon::ComponentDescription::class_name},
    tendon::Field{"library", &tendon::ComponentDescription::library},
    tendon::Field{"configuration", &tendon::ComponentDescription::configuration},
    tendon::Field{"state", &tendon::ComponentDescription::state},
    tendon::Field{"fault", &tendon::ComponentDescription::fault},
    tendon::Field{"fault_time", &tendon::ComponentDescription::fault_time, "ns"},
    tendon::Field{"warning", &tendon::ComponentDescription::warning},
    tendon::Field{"period", &tendon::ComponentDescription::period, "s"},
    tendon::Field{"thread", &tendon::ComponentDescription::thread},
    tendon::Field{"leader", &tendon::ComponentDescription::leader},
    tendon::Field{"provided", &tendon::ComponentDescription::provided},
    tendon::Field{"required", &tendon::ComponentDescription::required},
    tendon::Field{"tables", &tendon::ComponentDescription::tables});

template <>
inline constexpr auto tendon::kPayload<tendon::ConnectionDescription> = tendon::Describe(
    "tendon.ConnectionDescription", tendon::Field{"id", &tendon::ConnectionDescription::id},
    tendon::Field{"required", &tendon::ConnectionDescription::required},
    tendon::Field{"provided", &tendon::ConnectionDescription::provided},
    tendon::Field{"state", &tendon::ConnectionDescription::state},
    tendon::Field{"reason", &tendon::ConnectionDescription::reason},
    tendon::Field{"converted", &tendon::ConnectionDescription::converted});

template <>
inline constexpr auto tendon::kPayload<tendon::ConnectionCounts> = tendon::Describe(
    "tendon.ConnectionCounts", tendon::Field{"age", &tendon::ConnectionCounts::age},
    tendon::Field{"round_trip", &tendon::ConnectionCounts::round_trip},
    tendon::Field{"taken", &tendon::ConnectionCounts::taken},
    tendon::Field{"capacity", &tendon::ConnectionCounts::capacity},
    tendon::Field{"waiting", &tendon::ConnectionCounts::waiting},
    tendon::Field{"refused", &tendon::ConnectionCounts::refused},
    tendon::Field{"replaced", &tendon::ConnectionCounts::replaced},
    tendon::Field{"lost_events", &tendon::ConnectionCounts::lost_events});

template <>
inline constexpr auto tendon::kPayload<tendon::MailboxFill> =
    tendon::Describe("tendon.MailboxFill", tendon::Field{"waiting", &tendon::MailboxFill::waiting},
                     tendon::Field{"capacity", &tendon::MailboxFill::capacity});
