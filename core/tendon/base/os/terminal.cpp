#include <tendon/base/os/terminal.h>
#include <unistd.h>

namespace tendon::os {

bool IsTerminal(Stream stream) noexcept { return isatty(static_cast<int>(stream)) == 1; }

}  // namespace tendon::os
