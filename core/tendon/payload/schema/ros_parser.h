#pragma once

#include <tendon/base/result.h>
#include <tendon/payload/schema.h>

#include <string_view>

namespace tendon {

/// Reads the definition of the ROS 2 message `name`, "arm/msg/JointState", with the definitions of
/// nested messages behind it as in MCAP, also from untrusted sources. The schema decodes the
/// message in CDR. A time and a duration become a duration; bounds, default values and constants
/// are left out. Limits as Schema::Parse(). kInvalid for a mistake, a missing definition, or
/// wstring, of which ROS 2 does not define the encoding.
[[nodiscard]] Result<Schema> ParseRosMessage(std::string_view name, std::string_view text);

}  // namespace tendon
