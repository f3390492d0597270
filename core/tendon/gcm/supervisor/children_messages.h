#pragma once

#include <tendon/gcm/supervisor/restart_policy.h>
#include <tendon/middleware/frame.h>

#include <string>
#include <vector>

/// Messages about the processes that a GCM has started; the catalogue does not have this
/// information.
namespace tendon::message {

// From a viewer. A GCM that is older than this message refuses it.
inline constexpr auto kGetChildren = static_cast<MessageType>(0x31d);  // request: None -> Children

/// A process that the GCM has started, and can end or restart.
struct Child {
  std::string process;
  RestartPolicy restart = RestartPolicy::kNever;
};

/// The answer to kGetChildren.
struct Children {
  std::vector<Child> processes;  ///< by name
};

}  // namespace tendon::message

template <>
inline constexpr auto tendon::kPayload<tendon::message::Child> =
    tendon::Describe("tendon.Child", tendon::Field{"process", &tendon::message::Child::process},
                     tendon::Field{"restart", &tendon::message::Child::restart});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Children> = tendon::Describe(
    "tendon.Children", tendon::Field{"processes", &tendon::message::Children::processes});
