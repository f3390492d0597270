#pragma once

#include <tendon/manager/description.h>
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

/// What can be asked of a process and its components from afar.
enum class LifeVerb : std::int32_t {
  kLoad,       ///< a plug-in
  kCreate,     ///< a component of a class
  kConfigure,  ///< makes a component at rest anew with another configuration
  kStart,
  kSuspend,
  kStop,
  kRestart,  ///< stops it where it runs, then starts it
  kRemove,
};

template <>
inline constexpr auto kPayload<LifeVerb> = DescribeEnum(
    "tendon.LifeVerb", Enumerator{"load", LifeVerb::kLoad}, Enumerator{"create", LifeVerb::kCreate},
    Enumerator{"configure", LifeVerb::kConfigure}, Enumerator{"start", LifeVerb::kStart},
    Enumerator{"suspend", LifeVerb::kSuspend}, Enumerator{"stop", LifeVerb::kStop},
    Enumerator{"restart", LifeVerb::kRestart}, Enumerator{"remove", LifeVerb::kRemove});

/// "load", "create", ...
[[nodiscard]] constexpr std::string_view ToString(LifeVerb verb) noexcept { return NameOf(verb); }

/// A class of which a process can make components.
struct ClassDescription {
  std::string name;
  std::string library;
  std::string configuration;  ///< Schema::TextWithHelp(); of None where it takes none
  std::string defaults;       ///< the configuration of one that is told nothing, as JSON

  bool operator==(const ClassDescription&) const = default;
};

}  // namespace tendon

/// Orders for the life of components, from a viewer to its GCM and from that to the LCM. Each
/// struct is the body of a frame; all are requests.
namespace tendon::message {

// LifeOrder -> LifeOutcome; the LCM reports what has changed before it answers
inline constexpr auto kLife = static_cast<MessageType>(0x317);
inline constexpr auto kGetClasses = static_cast<MessageType>(0x318);  // GetClasses -> Classes
// From an LCM to its GCM, BeginOrder -> None: asked before an order is carried out. A refusal makes
// it void, for nobody waits for it any more: a process that was stopped for a while, or was busy,
// does nothing late.
inline constexpr auto kBeginOrder = static_cast<MessageType>(0x319);

/// The longest configuration, in bytes.
inline constexpr std::size_t kLongestConfiguration = std::size_t{1} << 16U;

/// One verb, for one component or library. What the verb has no use for is empty.
struct LifeOrder {
  std::uint64_t id = 0;  ///< the GCM's
  LifeVerb verb = LifeVerb::kStart;
  std::string process;
  std::uint64_t instance = 0;  ///< of the process that is meant; 0: whichever is there
  std::string component;       ///< all but load
  std::string class_name;      ///< create
  /// Load; create, where empty stands for the one loaded library that has the class.
  std::string library;
  std::string configuration;  ///< create, configure: JSON, or empty for the defaults
  /// Configure: BaseOf() the configuration that this one was made from. A component that has
  /// another one by now keeps that. Zeros: it replaces whichever there is.
  Fingerprint based_on;
  std::string thread;  ///< create: ThreadOptions as JSON, or empty for those of the class
  std::string leader;  ///< create: the component after which it runs, or empty
  /// Start: refused where a required interface that the component needs is not connected.
  bool is_strict = false;
  /// How long it may take; 0: as long as who passes it on finds right. What has not begun by then
  /// is not done any more.
  std::chrono::nanoseconds patience{0};
};

/// What was there before an order that was obeyed.
struct LifeOutcome {
  ComponentState state = ComponentState::kConstructed;  ///< all but load and create
  std::string class_name;                               ///< all but load
  std::string library;                                  ///< all but load
  std::string former;                                   ///< configure, remove: its configuration
  std::string configuration;                            ///< create, configure: as it was understood
  std::string thread;                                   ///< remove: as LifeOrder has it
  std::string leader;                                   ///< remove: likewise
  std::string warning;  ///< what is not as it was meant, though it was obeyed
};

/// Which order an LCM is about to carry out.
struct BeginOrder {
  std::uint64_t id = 0;
};

/// Which classes a process can make components of.
struct GetClasses {
  std::string process;
};

/// The answer to GetClasses.
struct Classes {
  std::vector<ClassDescription> classes;  ///< of the plug-ins that are loaded, by library and name
  std::vector<std::string> plugins;       ///< all that are in the process' plug-in folders
  std::vector<PluginDescription> loaded{};  ///< as of now
};

}  // namespace tendon::message

template <>
inline constexpr auto tendon::kPayload<tendon::ClassDescription> = tendon::Describe(
    "tendon.ClassDescription", tendon::Field{"name", &tendon::ClassDescription::name},
    tendon::Field{"library", &tendon::ClassDescription::library},
    tendon::Field{"configuration", &tendon::ClassDescription::configuration},
    tendon::Field{"defaults", &tendon::ClassDescription::defaults});

template <>
inline constexpr auto tendon::kPayload<tendon::message::LifeOrder> =
    tendon::Describe("tendon.LifeOrder", tendon::Field{"id", &tendon::message::LifeOrder::id},
                     tendon::Field{"verb", &tendon::message::LifeOrder::verb},
                     tendon::Field{"process", &tendon::message::LifeOrder::process},
                     tendon::Field{"instance", &tendon::message::LifeOrder::instance},
                     tendon::Field{"component", &tendon::message::LifeOrder::component},
                     tendon::Field{"class_name", &tendon::message::LifeOrder::class_name},
                     tendon::Field{"library", &tendon::message::LifeOrder::library},
                     tendon::Field{"configuration", &tendon::message::LifeOrder::configuration},
                     tendon::Field{"based_on", &tendon::message::LifeOrder::based_on},
                     tendon::Field{"thread", &tendon::message::LifeOrder::thread},
                     tendon::Field{"leader", &tendon::message::LifeOrder::leader},
                     tendon::Field{"is_strict", &tendon::message::LifeOrder::is_strict},
                     tendon::Field{"patience", &tendon::message::LifeOrder::patience});

template <>
inline constexpr auto tendon::kPayload<tendon::message::LifeOutcome> = tendon::Describe(
    "tendon.LifeOutcome", tendon::Field{"state", &tendon::message::LifeOutcome::state},
    tendon::Field{"class_name", &tendon::message::LifeOutcome::class_name},
    tendon::Field{"library", &tendon::message::LifeOutcome::library},
    tendon::Field{"former", &tendon::message::LifeOutcome::former},
    tendon::Field{"configuration", &tendon::message::LifeOutcome::configuration},
    tendon::Field{"thread", &tendon::message::LifeOutcome::thread},
    tendon::Field{"leader", &tendon::message::LifeOutcome::leader},
    tendon::Field{"warning", &tendon::message::LifeOutcome::warning});

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
