#include <gmock/gmock.h>
#include <tendon/security/certificate.h>

#include "core/security/authority.h"

namespace tendon {
namespace {

using testing::HasSubstr;

std::string Refusal(std::string_view pem) {
  const auto parsed = ParseCertificate(pem);
  EXPECT_FALSE(parsed.ok());
  if (parsed.ok()) return "";
  EXPECT_EQ(parsed.error().code, ErrorCode::kInvalid);
  return parsed.error().message;
}

class CertificateTest : public AuthorityTest {};

TEST_F(CertificateTest, OfAProcessIsValidForBothEnds) {
  const auto issued = Issue({.name = "robot", .holder = Holder::kProcess, .hosts = {"10.0.0.1"}});

  EXPECT_EQ(issued.certificate.holder, Holder::kProcess);
  EXPECT_EQ(issued.certificate.role, Role::kViewer);
}

TEST_F(CertificateTest, RefusesATruncatedCertificate) {
  Issue({.name = "robot"});
  const std::string pem = home.Read("out/robot.crt");

  const std::size_t end = pem.rfind("-----");
  for (std::size_t size = 0; size < end; ++size) {
    EXPECT_FALSE(ParseCertificate(std::string_view(pem).substr(0, size)).ok()) << size;
  }
}

TEST_F(CertificateTest, HandlesAnyChangedCharacter) {
  Issue({.name = "robot"});
  const std::string pem = home.Read("out/robot.crt");

  for (std::size_t at = 0; at < pem.size(); ++at) {
    std::string changed = pem;
    changed[at] = changed[at] == 'A' ? 'B' : 'A';
    const auto parsed = ParseCertificate(changed);
    EXPECT_TRUE(parsed.ok() || parsed.error().code == ErrorCode::kInvalid) << at;
  }
}

TEST_F(CertificateTest, RefusesTheCertificateOfACa) {
  EXPECT_THAT(Refusal(home.Read("ca/ca.crt")), HasSubstr("the certificate of a CA"));
}

TEST(Certificate, RefusesATooLongText) {
  EXPECT_THAT(Refusal(std::string(kMaxCertificateSize + 1, '-')), HasSubstr("the longest has"));
  EXPECT_THAT(Refusal("hello"), HasSubstr("is not a certificate"));
}

TEST(Certificate, DatesAreInUtc) {
  EXPECT_EQ(DateText(std::chrono::sys_seconds{}), "1970-01-01 00:00:00Z");
  EXPECT_EQ(DateText(std::chrono::sys_days{std::chrono::year(2027) / 2 / 28} +
                     std::chrono::seconds(86399)),
            "2027-02-28 23:59:59Z");
}

TEST(Role, RoundTripsThroughText) {
  for (const Role role : {Role::kViewer, Role::kOperator}) {
    EXPECT_EQ(*ParseRole(ToString(role)), role);
  }
  EXPECT_EQ(ParseRole("root\x1b").error().message, "role 'root\\x1b': expected viewer or operator");
}

}  // namespace
}  // namespace tendon
