#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>

#include <string>

namespace console {

/// The object that a path names in a catalogue, and the objects that contain it. Pointers to
/// objects below it are null. The pointers are valid until the catalogue changes.
struct PathTarget {
  const tendon::ProcessEntry* process = nullptr;
  const tendon::ComponentDescription* component = nullptr;
  const tendon::ProvidedDescription* provided = nullptr;
  const tendon::RequiredDescription* required = nullptr;
  const tendon::MemberDescription* member = nullptr;  ///< a command, event, function or handler
  std::string noun;  ///< kind of the member: "command", "event", "function" or "event handler"
};

/// Finds the object with the path "process/component/interface.member", or with only the first
/// parts of such a path. kNotFound suggests similar names. kInvalid means that the path continues
/// into a value.
tendon::Result<PathTarget> FindTarget(const tendon::Catalogue& catalogue, const std::string& path);

/// Returns the types of a member: "arm.LinkId -> geometry_msgs.Pose", "double[7]". Empty if it has
/// neither an argument nor a result.
std::string TypesOf(const tendon::MemberDescription& member);
bool HasResult(const tendon::MemberDescription& member);

}  // namespace console
