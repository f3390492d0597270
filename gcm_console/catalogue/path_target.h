#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>

#include <string>

namespace console {

/// The target of a path in a catalogue, and the things above it; those below it are
/// null. The pointers are valid until the catalogue changes.
struct PathTarget {
  const tendon::ProcessEntry* process = nullptr;
  const tendon::ComponentDescription* component = nullptr;
  const tendon::ProvidedDescription* provided = nullptr;
  const tendon::RequiredDescription* required = nullptr;
  const tendon::MemberDescription* member = nullptr;  ///< a command, event, function or handler
  std::string noun;                                   ///< the kind of the member, one of these four
};

/// Finds "process/component/interface.member" or the beginning of such a path. kNotFound suggests
/// similar names; kInvalid if the path continues into a value.
tendon::Result<PathTarget> FindTarget(const tendon::Catalogue& catalogue, const std::string& path);

/// "arm.LinkId -> geometry_msgs.Pose", "double[7]"; empty without argument and result.
std::string TypesOf(const tendon::MemberDescription& member);
bool HasAnswer(const tendon::MemberDescription& member);

}  // namespace console
