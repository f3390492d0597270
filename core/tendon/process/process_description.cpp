#include <tendon/process/process_description.h>

namespace tendon {

std::string_view ToString(ProcessState state) noexcept { return NameOf(state); }

}  // namespace tendon
