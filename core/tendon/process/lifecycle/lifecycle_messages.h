#pragma once

#include <tendon/manager/component_description.h>
#include <tendon/middleware/frame.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/payload/payload.h>
#include <tendon/task/component_state.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// The kinds of orders for a process or its components.
enum class LifecycleVerb : std::int32_t {
  kLoad,       ///< loads a plug-in
  kCreate,     ///< creates a component of a class
  kConfigure,  ///< creates a stopped component again, with another configuration
  kStart,
  kSuspend,
  kStop,
  kRestart,  ///< stops the component if it runs, then starts it
  kRemove,
};

template <>
inline constexpr auto kPayload<LifecycleVerb> = DescribeEnum(
    "tendon.LifeVerb", Enumerator{"load", LifecycleVerb::kLoad},
    Enumerator{"create", LifecycleVerb::kCreate},
    Enumerator{"configure", LifecycleVerb::kConfigure}, Enumerator{"start", LifecycleVerb::kStart},
    Enumerator{"suspend", LifecycleVerb::kSuspend}, Enumerator{"stop", LifecycleVerb::kStop},
    Enumerator{"restart", LifecycleVerb::kRestart}, Enumerator{"remove", LifecycleVerb::kRemove});

/// Returns "load", "create", ...
[[nodiscard]] constexpr std::string_view ToString(LifecycleVerb verb) noexcept {
  return NameOf(verb);
}

/// A class from which a process can create components.
struct ClassDescription {
  std::string name;
  std::string library;
  std::string configuration;  ///< Schema::TextWithHelp() of its type, or of None
  std::string defaults;       ///< the default configuration, as JSON

  bool operator==(const ClassDescription&) const = default;
};

}  // namespace tendon

/// Orders for the lifecycle of components. A viewer sends them to its GCM, and the GCM sends them
/// to the LCM. Each struct is the body of a frame. All messages are requests.
namespace tendon::message {

// LifecycleOrder -> LifecycleOutcome. The LCM reports the changes before it answers.
inline constexpr auto kLifecycleOrder = static_cast<MessageType>(0x317);
inline constexpr auto kGetClasses = static_cast<MessageType>(0x318);  // GetClasses -> Classes
// BeginOrder -> None. An LCM sends this request to its GCM before it executes an order. The GCM
// refuses it if the sender of the order has stopped waiting; then the LCM does not execute the
// order. Therefore, a process that was suspended or busy does not execute an outdated order.
inline constexpr auto kBeginOrder = static_cast<MessageType>(0x319);

/// The longest configuration, in bytes.
inline constexpr std::size_t kLongestConfiguration = std::size_t{1} << 16U;

/// One order, for one component or library. Fields that the verb of the order does not use are
/// empty.
struct LifecycleOrder {
  std::uint64_t id = 0;  ///< number that the GCM has issued
  LifecycleVerb verb = LifecycleVerb::kStart;
  std::string process;
  std::uint64_t instance = 0;  ///< instance of the target process; 0: any
  std::string component;       ///< for all verbs except load
  std::string class_name;      ///< for create
  /// For load and create. If it is empty for create, the only loaded library that has this class is
  /// used.
  std::string library;
  std::string configuration;  ///< for create and configure: JSON; empty for the defaults
  /// For configure: BaseOf() of the configuration from which the new configuration was made. The
  /// order is refused if the component now has another configuration. All zeros: the order replaces
  /// any configuration.
  Fingerprint based_on;
  std::string thread;  ///< for create: ThreadOptions as JSON; empty: the class chooses
  std::string leader;  ///< for create: the component after which it runs, or empty
  /// For start: refuses the order if an interface that the component needs is not connected.
  bool is_strict = false;
  /// The time limit. An order that has not begun within this time is not executed. If 0, the
  /// program that forwards the order chooses the limit.
  std::chrono::nanoseconds timeout{0};
};

/// The result of an executed order, and the state before it.
struct LifecycleOutcome {
  /// The state before the order. Not filled in for load and create.
  ComponentState state = ComponentState::kConstructed;
  std::string class_name;     ///< not filled in for load
  std::string library;        ///< not filled in for load
  std::string former;         ///< for configure and remove: the configuration before the order
  std::string configuration;  ///< for create and configure: the new configuration, with all fields
  std::string thread;         ///< for remove: the thread options, as in LifecycleOrder
  std::string leader;         ///< for remove: the leader, as in LifecycleOrder
  std::string warning;        ///< the difference between the result and the order; usually empty
};

/// The order that an LCM is about to execute.
struct BeginOrder {
  std::uint64_t id = 0;
};

/// Asks for the classes from which a process can create components.
struct GetClasses {
  std::string process;
};

/// The reply to GetClasses.
struct Classes {
  std::vector<ClassDescription> classes;    ///< of the loaded plug-ins, sorted by library and name
  std::vector<std::string> plugins;         ///< all libraries in the plug-in folders of the process
  std::vector<PluginDescription> loaded{};  ///< the loaded plug-ins
};

}  // namespace tendon::message

template <>
inline constexpr auto tendon::kPayload<tendon::ClassDescription> = tendon::Describe(
    "tendon.ClassDescription", tendon::Field{"name", &tendon::ClassDescription::name},
    tendon::Field{"library", &tendon::ClassDescription::library},
    tendon::Field{"configuration", &tendon::ClassDescription::configuration},
    tendon::Field{"defaults", &tendon::ClassDescription::defaults});

template <>
inline constexpr auto tendon::kPayload<tendon::message::LifecycleOrder> = tendon::Describe(
    "tendon.LifeOrder", tendon::Field{"id", &tendon::message::LifecycleOrder::id},
    tendon::Field{"verb", &tendon::message::LifecycleOrder::verb},
    tendon::Field{"process", &tendon::message::LifecycleOrder::process},
    tendon::Field{"instance", &tendon::message::LifecycleOrder::instance},
    tendon::Field{"component", &tendon::message::LifecycleOrder::component},
    tendon::Field{"class_name", &tendon::message::LifecycleOrder::class_name},
    tendon::Field{"library", &tendon::message::LifecycleOrder::library},
    tendon::Field{"configuration", &tendon::message::LifecycleOrder::configuration},
    tendon::Field{"based_on", &tendon::message::LifecycleOrder::based_on},
    tendon::Field{"thread", &tendon::message::LifecycleOrder::thread},
    tendon::Field{"leader", &tendon::message::LifecycleOrder::leader},
    tendon::Field{"is_strict", &tendon::message::LifecycleOrder::is_strict},
    tendon::Field{"timeout", &tendon::message::LifecycleOrder::timeout});

template <>
inline constexpr auto tendon::kPayload<tendon::message::LifecycleOutcome> = tendon::Describe(
    "tendon.LifeOutcome", tendon::Field{"state", &tendon::message::LifecycleOutcome::state},
    tendon::Field{"class_name", &tendon::message::LifecycleOutcome::class_name},
    tendon::Field{"library", &tendon::message::LifecycleOutcome::library},
    tendon::Field{"former", &tendon::message::LifecycleOutcome::former},
    tendon::Field{"configuration", &tendon::message::LifecycleOutcome::configuration},
    tendon::Field{"thread", &tendon::message::LifecycleOutcome::thread},
    tendon::Field{"leader", &tendon::message::LifecycleOutcome::leader},
    tendon::Field{"warning", &tendon::message::LifecycleOutcome::warning});

template <>
inline constexpr auto tendon::kPayload<tendon::message::BeginOrder> =
    tendon::Describe("tendon.BeginOrder", tendon::Field{"id", &tendon::message::BeginOrder::id});

template <>
inline constexpr auto tendon::kPayload<tendon::message::GetClasses> = tendon::Describe(
    "tendon.GetClasses", tendon::Field{"process", &tendon::message::GetClasses::process});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Classes> =
    tendon::Describe("tendon.Classes", tendon::Field{"classes", &tendon::message::Classes::classes},
                     tendon::Field{"plugins", &tendon::message::Classes::plugins},
                     tendon::Field{"loaded", &tendon::message::Classes::loaded});
