#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/catalog.h>

#include <string>

namespace console {

/// What a path names in a catalogue: as deep as the path goes, the rest null. Lives as long as the
/// catalogue is not changed.
struct Place {
  const tendon::ProcessEntry* process = nullptr;
  const tendon::ComponentDescription* component = nullptr;
  const tendon::ProvidedDescription* provided = nullptr;
  const tendon::RequiredDescription* required = nullptr;
  const tendon::MemberDescription* member = nullptr;  ///< a command, event, function or handler
  std::string noun;                                   ///< which of these
};

/// The place of "process/component/interface.member" or of the beginning of such a path. kNotFound
/// names what is near; kInvalid where the path goes on into a value.
tendon::Result<Place> FindPlace(const tendon::Catalog& catalog, const std::string& path);

/// "arm.LinkId -> geometry_msgs.Pose", "double[7]", or nothing where neither goes in or out.
std::string TypesOf(const tendon::MemberDescription& member);
bool GivesAnswer(const tendon::MemberDescription& member);

}  // namespace console
