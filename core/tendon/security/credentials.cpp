#include <tendon/base/os/process.h>
#include <tendon/security/credentials.h>

namespace tendon {

std::filesystem::path UsualAuthority() { return os::StateFolder() / "ca"; }

}  // namespace tendon
