#pragma once

#include <tendon/manager/component_description.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// The state of a process, as the GCM knows it.
enum class ProcessState : std::int32_t {
  kAlive,
  kSuspect,   ///< has missed lease renewals
  kLost,      ///< connection broken or lease expired; the description is kept
  kLeft,      ///< has left the GCM on its own; the description is kept
  kStarting,  ///< the GCM has started its program, which has not joined yet
};

template <>
inline constexpr auto kPayload<ProcessState> = DescribeEnum(
    "tendon.ProcessState", Enumerator{"alive", ProcessState::kAlive},
    Enumerator{"suspect", ProcessState::kSuspect}, Enumerator{"lost", ProcessState::kLost},
    Enumerator{"left", ProcessState::kLeft}, Enumerator{"starting", ProcessState::kStarting});

[[nodiscard]] constexpr std::string_view ToString(ProcessState state) noexcept {
  return NameOf(state);
}

/// The description of a process, without its components.
struct ProcessDescription {
  std::string name;
  std::uint64_t instance = 0;  ///< new at each start of the process
  std::string host;
  std::int64_t pid = 0;
  std::string address;  ///< where viewers and peers connect
  ProcessState state = ProcessState::kAlive;
  /// The reason why the process is lost; for a living process, the hosts that cannot reach it.
  std::string reason;
  std::int64_t since = 0;  ///< time of entering `state`, ns since 1970; only for display
  std::vector<PluginDescription> plugins{};  ///< in the order of loading

  bool operator==(const ProcessDescription&) const = default;
};

/// One change of the catalogue. Changes have numbers without gaps, called revisions. One of the
/// lists has one element, and the others are empty; a removal has a name or an id instead.
struct CatalogueChange {
  enum class Kind : std::int32_t {
    kProcess,  ///< added or changed; a new instance begins without components and connections
    kProcessRemoved,
    kComponent,  ///< added or changed
    kComponentRemoved,
    kConnection,  ///< added or changed
    kConnectionRemoved,
  };

  std::uint64_t revision = 0;  ///< revision of the catalogue after this change
  Kind kind = Kind::kProcess;
  std::string process;                             ///< the process that has changed
  std::string component;                           ///< kComponentRemoved
  std::uint64_t connection = 0;                    ///< kConnectionRemoved
  std::vector<ProcessDescription> processes;       ///< kProcess
  std::vector<ComponentDescription> components;    ///< kComponent
  std::vector<ConnectionDescription> connections;  ///< kConnection

  bool operator==(const CatalogueChange&) const = default;
};

}  // namespace tendon

template <>
inline constexpr auto tendon::kPayload<tendon::ProcessDescription> = tendon::Describe(
    "tendon.ProcessDescription", tendon::Field{"name", &tendon::ProcessDescription::name},
    tendon::Field{"instance", &tendon::ProcessDescription::instance},
    tendon::Field{"host", &tendon::ProcessDescription::host},
    tendon::Field{"pid", &tendon::ProcessDescription::pid},
    tendon::Field{"address", &tendon::ProcessDescription::address},
    tendon::Field{"state", &tendon::ProcessDescription::state},
    tendon::Field{"reason", &tendon::ProcessDescription::reason},
    tendon::Field{"since", &tendon::ProcessDescription::since, "ns"},
    tendon::Field{"plugins", &tendon::ProcessDescription::plugins});

template <>
inline constexpr auto tendon::kPayload<tendon::CatalogueChange::Kind> = tendon::DescribeEnum(
    "tendon.CatalogueChangeKind",
    tendon::Enumerator{"process", tendon::CatalogueChange::Kind::kProcess},
    tendon::Enumerator{"process_removed", tendon::CatalogueChange::Kind::kProcessRemoved},
    tendon::Enumerator{"component", tendon::CatalogueChange::Kind::kComponent},
    tendon::Enumerator{"component_removed", tendon::CatalogueChange::Kind::kComponentRemoved},
    tendon::Enumerator{"connection", tendon::CatalogueChange::Kind::kConnection},
    tendon::Enumerator{"connection_removed", tendon::CatalogueChange::Kind::kConnectionRemoved});

template <>
inline constexpr auto tendon::kPayload<tendon::CatalogueChange> = tendon::Describe(
    "tendon.CatalogueChange", tendon::Field{"revision", &tendon::CatalogueChange::revision},
    tendon::Field{"kind", &tendon::CatalogueChange::kind},
    tendon::Field{"process", &tendon::CatalogueChange::process},
    tendon::Field{"component", &tendon::CatalogueChange::component},
    tendon::Field{"connection", &tendon::CatalogueChange::connection},
    tendon::Field{"processes", &tendon::CatalogueChange::processes},
    tendon::Field{"components", &tendon::CatalogueChange::components},
    tendon::Field{"connections", &tendon::CatalogueChange::connections});
