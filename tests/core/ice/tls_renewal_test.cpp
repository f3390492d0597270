#include "core/ice/tls_fixture.h"

namespace tendon::ice {
namespace {

using testing::HasSubstr;

class TlsRenewal : public TlsTest {
 protected:
  /// Replaces the certificate of `name`, and revokes all its earlier certificates.
  void Renew(const std::string& name) const { Put(Reissued(RequestOf(name)), name); }
  [[nodiscard]] CertificateAuthority::IssuedCertificate Reissued(const Request& request) const {
    EXPECT_TRUE(authority->Revoke(request.name).ok());
    return IssueElsewhere(request);
  }
  [[nodiscard]] CertificateAuthority::IssuedCertificate IssueElsewhere(
      const Request& request) const {
    const auto issued = authority->Issue(request, home.path() / "renewed");
    EXPECT_TRUE(issued.ok());
    return *issued;
  }
  void Put(const CertificateAuthority::IssuedCertificate& issued, const std::string& name) const {
    fs::rename(issued.key_file, out / (name + ".key"));
    fs::rename(issued.certificate_file, out / (name + ".crt"));
  }
  static Request RequestOf(const std::string& name) {
    return {.name = name, .role = Role::kOperator, .holder = kProcess};
  }
  [[nodiscard]] bool EventuallyLogged(const std::string& text) const {
    return EventuallyTrue([&] {
      const auto texts = log_.texts();
      return std::any_of(texts.begin(), texts.end(),
                         [&](const std::string& line) { return line.find(text) != line.npos; });
    });
  }

  const tendon_test::LogRecord log_{"certificate"};
};

TEST_F(TlsRenewal, AListenerShowsARenewedCertificate) {
  const auto anna = As({.name = "anna"});
  const auto address = Listen(robot_, "robot");
  ASSERT_TRUE(authority->Revoke("robot").ok());
  ASSERT_THAT(Refusal(anna, address).message, HasSubstr("was revoked"));

  Put(IssueElsewhere(RequestOf("robot")), "robot");

  const auto channel = Open(anna, address, "gcm ls", "robot");
  ASSERT_TRUE(channel.ok()) << channel.error().message;
  EXPECT_EQ((*channel)->peer().name, "robot");
  EXPECT_TRUE(EventuallyLogged("this program now uses the renewed certificate " +
                               (out / "robot.crt").string()));
}

TEST_F(TlsRenewal, AnOpenerShowsARenewedCertificate) {
  const auto arm = As(RequestOf("arm"));
  const auto address = Listen(robot_, "robot");
  ASSERT_TRUE(authority->Revoke("arm").ok());
  ASSERT_FALSE(Open(arm, address, "arm").ok());
  ASSERT_TRUE(EventuallyAudited("was refused: the certificate of 'arm' was revoked"));

  Put(IssueElsewhere(RequestOf("arm")), "arm");

  EXPECT_TRUE(Open(arm, address, "arm").ok());
}

TEST_F(TlsRenewal, ARenewalKeepsOpenLinks) {
  const auto anna = As({.name = "anna"});
  const auto address = Listen(robot_, "robot");
  const auto standing = Open(anna, address, "gcm ls", "robot");
  ASSERT_TRUE(standing.ok());

  Renew("robot");

  ASSERT_TRUE(Open(anna, address, "gcm ls", "robot").ok());
  EXPECT_TRUE((*standing)->is_open());
}

TEST_F(TlsRenewal, ReportsAnInvalidCertificateAndKeepsTheOld) {
  const auto anna = As({.name = "anna"});
  const auto address = Listen(robot_, "robot");
  const auto put = [&](const Request& request) {
    Put(IssueElsewhere(request), "robot");
    return Open(anna, address, "gcm ls", "robot").ok();
  };

  EXPECT_TRUE(put(RequestOf("arm")));
  EXPECT_TRUE(EventuallyLogged("now belongs to the process 'arm' with the role operator"));
  EXPECT_TRUE(put({.name = "robot", .role = Role::kViewer, .holder = kProcess}));
  EXPECT_TRUE(EventuallyLogged("now belongs to the process 'robot' with the role viewer"));

  const auto renewed = IssueElsewhere(RequestOf("robot"));
  fs::permissions(renewed.key_file, fs::perms::others_read, fs::perm_options::add);
  Put(renewed, "robot");
  EXPECT_TRUE(Open(anna, address, "gcm ls", "robot").ok());
  EXPECT_TRUE(EventuallyLogged("robot.key"));
  fs::remove(out / "robot.crt");
  EXPECT_TRUE(Open(anna, address, "gcm ls", "robot").ok());
  EXPECT_TRUE(EventuallyLogged("robot.crt"));
}

TEST_F(TlsRenewal, ACertificateIsUsedOnlyWithItsKey) {
  const auto anna = As({.name = "anna"});
  const auto address = Listen(robot_, "robot");
  const auto renewed = Reissued(RequestOf("robot"));

  fs::rename(renewed.certificate_file, out / "robot.crt");
  EXPECT_THAT(Refusal(anna, address).message, HasSubstr("was revoked")) << "still the one before";
  EXPECT_TRUE(EventuallyLogged("does not belong to"));
  fs::rename(renewed.key_file, out / "robot.key");

  EXPECT_TRUE(Open(anna, address, "gcm ls", "robot").ok());
}

}  // namespace
}  // namespace tendon::ice
