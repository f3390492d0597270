#include <tendon/interface/offer.h>

#include <tendon/base/error.h>

namespace tendon {

Offer& Offer::SetExpiry(std::chrono::nanoseconds after, std::function<void()> end) {
  using namespace std::chrono_literals;
  const std::string what = "command '" + description_.name + "'";
  if (after < 1ms || after > 3600s) {
    throw ConfigurationError(what + " must expire after 1 ms..3600 s, got " +
                             std::to_string(after.count()) + " ns");
  }
  if (!uses_mailbox()) {
    throw ConfigurationError(what +
                             " cannot expire: it runs in the thread of its caller. Only commands "
                             "that run in the thread of the component can expire");
  }
  if (end == nullptr) {
    throw ConfigurationError(what + " needs a function that ends its effect; this one is empty");
  }
  description_.expires_after = std::chrono::duration<double>(after).count();
  expiry_ = std::make_unique<Expiry>(description_.name, after, std::move(end));
  return *this;
}

}  // namespace tendon
