#pragma once

#include <tendon/base/result.h>
#include <tendon/payload/schema.h>

#include <string_view>

namespace tendon {

/// Reads the definition of a ROS 2 message and returns its schema, with which the message can be
/// decoded from CDR. `name` is for example "arm/msg/JointState". The text, which may come from an
/// untrusted source, also has the definitions of nested messages after the first one, as in MCAP. A
/// time and a duration become a duration; bounds, default values and constants are left out. The
/// limits are the same as for Schema::Parse(). Fails with kInvalid for a mistake, a missing
/// definition, or the type wstring, whose encoding ROS 2 does not define.
[[nodiscard]] Result<Schema> ParseRosMessage(std::string_view name, std::string_view text);

}  // namespace tendon
