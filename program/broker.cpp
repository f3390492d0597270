#include <program/broker.h>

#ifdef TENDON_WITH_ICE
#include <tendon/ice/broker.h>
#endif

namespace program {

using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;

#ifdef TENDON_WITH_ICE

Result<std::string> BrokerSettings(const std::string& address, const NetworkOptions& options) {
  if (auto installed = tendon::ice::CheckBrokerIsInstalled(); !installed) return installed.error();
  if (options.certificate.empty()) return tendon::ice::BrokerSettings(address);
  const auto middleware = MakeMiddleware(options);  // also checks the certificate
  if (!middleware) return middleware.error();
  const tendon::Certificate& own = *(*middleware)->certificate();
  if (own.name == tendon::ice::kBrokerName && own.holder == tendon::Holder::kProcess) {
    return tendon::ice::BrokerSettings(
        address, {.certificate = options.certificate, .authority = AuthorityOf(options)});
  }
  return Error{
      ErrorCode::kDenied,
      "the broker needs a certificate with the name 'broker' for a process (gcm cert issue "
      "broker --role viewer --process); the given certificate has the name '" +
          own.name + "', for a " + std::string(ToString(own.holder))};
}

#else

Result<std::string> BrokerSettings(const std::string& /*address*/,
                                   const NetworkOptions& /*options*/) {
  return Error{
      ErrorCode::kInvalid,
      "this program was built without Ice, but the broker needs Ice: use a build with Ice"};
}

#endif

}  // namespace program
