#include <tendon/base/os/descriptor.h>
#include <unistd.h>

namespace tendon::os {

void Descriptor::Close() noexcept {
  if (value_ >= 0) close(value_);
  value_ = -1;
}

}  // namespace tendon::os
