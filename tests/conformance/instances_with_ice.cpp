#include <tendon/ice/ice_middleware.h>
#include <tendon/security/certificate_authority.h>

#include <cstdlib>
#include <map>

#include "conformance/contract.h"
#include "support/folder.h"

namespace tendon::conformance {
namespace {

Pair MakeIce(Exposure exposure) {
  return {MakeIceMiddleware(exposure), MakeIceMiddleware(exposure)};
}

/// Certificates for the tests. They are made only once, because making keys takes longer than the
/// tests.
class Certified {
 public:
  Certified() {
    // The program conformance_peer reads these variables.
    setenv("TENDON_CERTIFICATE", Issue("peer").c_str(), 1);
    setenv("TENDON_CA", authority_->folder().c_str(), 1);
  }

  [[nodiscard]] std::shared_ptr<Middleware> As(const std::string& name) {
    auto& certificate = certificates_[name];
    if (certificate.empty()) certificate = Issue(name);
    return *MakeIceMiddleware(
        Credentials{.certificate = certificate, .authority = authority_->folder()});
  }

 private:
  [[nodiscard]] std::string Issue(const std::string& name) const {
    const auto issued = authority_->Issue(
        {.name = name, .role = Role::kOperator, .holder = Holder::kProcess}, home_.path() / "keys");
    return issued->certificate_file;
  }

  const test::Folder home_;
  const Result<CertificateAuthority> authority_ = CertificateAuthority::Init(home_.path() / "ca");
  std::map<std::string, std::string> certificates_;
};

Pair MakeTls(Exposure /*exposure*/) {
  static Certified certified;
  return {certified.As("robot"), certified.As("desk")};
}

const auto kPlain = testing::Values(Kind{"ice", MakeIce});
const auto kIce = testing::Values(Kind{"ice", MakeIce}, Kind{"tls", MakeTls});

INSTANTIATE_TEST_SUITE_P(WithIce, ExposureContract, kPlain, NameOfKind);
INSTANTIATE_TEST_SUITE_P(WithIce, CookieContract, kPlain, NameOfKind);
INSTANTIATE_TEST_SUITE_P(WithIce, LinkContract, kIce, NameOfKind);
INSTANTIATE_TEST_SUITE_P(WithIce, AddressContract, kIce, NameOfKind);
INSTANTIATE_TEST_SUITE_P(WithIce, LifetimeContract, kIce, NameOfKind);
INSTANTIATE_TEST_SUITE_P(WithIce, PortContract, kIce, NameOfKind);
INSTANTIATE_TEST_SUITE_P(WithIce, ChannelContract, kIce, NameOfKind);
INSTANTIATE_TEST_SUITE_P(WithIce, LargeMessageContract, kIce, NameOfKind);
INSTANTIATE_TEST_SUITE_P(WithIce, LaterReplyContract, kIce, NameOfKind);

}  // namespace
}  // namespace tendon::conformance
