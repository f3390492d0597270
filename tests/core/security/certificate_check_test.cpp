#include <gmock/gmock.h>
#include <tendon/security/authority_folder.h>
#include <tendon/security/certificate_check.h>
#include <tendon/security/trusted_authority.h>

#include <atomic>
#include <thread>
#include <vector>

#include "core/security/authority.h"
#include "support/wait.h"

namespace tendon {
namespace {

namespace fs = std::filesystem;
using std::chrono::days;
using testing::HasSubstr;

class CertificateCheckTest : public AuthorityTest {
 protected:
  void SetUp() override {
    Issue({.name = "robot",
           .role = Role::kOperator,
           .holder = Holder::kProcess,
           .hosts = {"robot.local", "192.168.0.7", "fe80::1"}});
  }
  [[nodiscard]] Result<CheckedCertificate> Check(std::chrono::sys_seconds when = Now()) const {
    return CheckCertificate(out / "robot.crt", folder, when);
  }
  void ExpectBad(ErrorCode code, const std::string& sentence,
                 std::chrono::sys_seconds when = Now()) const {
    const auto checked = Check(when);
    ASSERT_FALSE(checked.ok()) << sentence;
    EXPECT_EQ(checked.error().code, code) << checked.error().message;
    EXPECT_THAT(checked.error().message, HasSubstr(sentence));
  }
};

TEST_F(CertificateCheckTest, ReturnsTheIdentityOfAValidCertificate) {
  const auto checked = Check();

  ASSERT_TRUE(checked.ok()) << checked.error().message;
  EXPECT_EQ(checked->certificate.name, "robot");
  EXPECT_EQ(checked->certificate.role, Role::kOperator);
  EXPECT_EQ(checked->certificate.holder, Holder::kProcess);
  EXPECT_EQ(checked->key, out / "robot.key");
  EXPECT_EQ(checked->warning, "");
}

TEST_F(CertificateCheckTest, NeedsNoPrivateKey) {
  fs::remove(out / "robot.key");
  fs::remove(folder / "ca.key");

  const auto checked = Check();

  ASSERT_TRUE(checked.ok()) << checked.error().message;
  EXPECT_EQ(checked->key, std::nullopt);
}

TEST_F(CertificateCheckTest, WarnsBeforeItExpires) {
  const auto last = Check()->certificate.not_after;

  EXPECT_EQ(Check(last - kExpiresSoon)->warning, "");
  EXPECT_THAT(Check(last - days(3))->warning, HasSubstr(", in 3 days: issue another with"));
  ExpectBad(ErrorCode::kDenied, "expired on " + DateText(last), last + std::chrono::seconds(1));
}

TEST_F(CertificateCheckTest, RefusesACertificateThatIsNotYetValid) {
  ExpectBad(ErrorCode::kDenied, "check the clock of this machine", Now() - days(1));
}

TEST_F(CertificateCheckTest, RefusesARevokedButNotANewCertificate) {
  ASSERT_TRUE(authority->Revoke("robot").ok());
  const auto next = authority->Issue({.name = "robot"}, home.path() / "next");
  ASSERT_TRUE(next.ok()) << next.error().message;

  ExpectBad(ErrorCode::kDenied, "was revoked (serial ");
  EXPECT_TRUE(CheckCertificate(next->certificate_file, folder, Now()).ok());
}

TEST_F(CertificateCheckTest, ARevocationIsPermanent) {
  Issue({.name = "desk"});

  ASSERT_TRUE(authority->Revoke("robot").ok());
  ASSERT_TRUE(authority->Revoke("desk").ok());

  ExpectBad(ErrorCode::kDenied, "was revoked");
}

TEST_F(CertificateCheckTest, RequiresARevocationList) {
  fs::remove(folder / "crl.pem");
  ExpectBad(ErrorCode::kNotFound, "crl.pem: copy this file from the CA");

  home.Write("ca/crl.pem", "nonsense");
  ExpectBad(ErrorCode::kInvalid, "is not a list of revoked certificates");
}

TEST_F(CertificateCheckTest, RefusesTheRevocationListOfAnotherCa) {
  ASSERT_TRUE(CertificateAuthority::Init(home.path() / "other").ok());
  fs::copy_file(home.path() / "other" / "crl.pem", folder / "crl.pem",
                fs::copy_options::overwrite_existing);

  ExpectBad(ErrorCode::kDenied, "cannot be trusted: unable to get certificate CRL");
}

TEST_F(CertificateCheckTest, RefusesTheCertificateOfAnotherCa) {
  const auto other = CertificateAuthority::Init(home.path() / "other");
  ASSERT_TRUE(other.ok()) << other.error().message;
  const auto foreign = other->Issue({.name = "robot"}, home.path() / "foreign");
  ASSERT_TRUE(foreign.ok()) << foreign.error().message;

  const auto checked = CheckCertificate(foreign->certificate_file, folder, Now());

  ASSERT_FALSE(checked.ok());
  EXPECT_EQ(checked.error().code, ErrorCode::kDenied);
  EXPECT_THAT(checked.error().message, HasSubstr("was not issued by the CA in " + folder.string()));
}

TEST_F(CertificateCheckTest, RefusesTheCertificateOfTheCa) {
  const auto checked = CheckCertificate(folder / "ca.crt", folder, Now());

  ASSERT_FALSE(checked.ok());
  EXPECT_THAT(checked.error().message, HasSubstr("the certificate of a CA"));
}

TEST_F(CertificateCheckTest, RefusesAKeyReadableByOthers) {
  for (const unsigned mode : {0604U, 0640U, 0620U, 0601U}) {
    fs::permissions(out / "robot.key", fs::perms(mode));
    ExpectBad(ErrorCode::kDenied, "robot.key can be read by others (mode 0" +
                                      std::to_string(mode / 64) + std::to_string(mode / 8 % 8) +
                                      std::to_string(mode % 8) + "): chmod 600 ");
  }
}

TEST_F(CertificateCheckTest, RefusesAForeignKey) {
  Issue({.name = "desk"});
  fs::rename(out / "desk.key", out / "robot.key");

  ExpectBad(ErrorCode::kDenied, "robot.key does not belong to ");
}

TEST_F(CertificateCheckTest, ReportsFilesThatAreNotCertificates) {
  fs::remove(out / "robot.crt");
  ExpectBad(ErrorCode::kNotFound, "there is no file ");

  fs::create_directory(out / "robot.crt");
  ExpectBad(ErrorCode::kInvalid, "is not an ordinary file");
  fs::remove(out / "robot.crt");

  home.Write("out/robot.crt", "nonsense");
  ExpectBad(ErrorCode::kInvalid, "is not a certificate (PEM)");

  home.Write("out/robot.crt", std::string((1U << 20U) + 1, 'x'));
  ExpectBad(ErrorCode::kInvalid, "larger than the limit of 1 MiB");
}

TEST_F(CertificateCheckTest, DoesNotQuoteAPrivateKey) {
  fs::copy_file(out / "robot.key", out / "robot.crt", fs::copy_options::overwrite_existing);

  ExpectBad(ErrorCode::kInvalid, "contains a private key");
  EXPECT_EQ(Check().error().message.find("BEGIN"), std::string::npos);
}

TEST_F(CertificateCheckTest, IsSafeDuringChangesOfTheCa) {
  openssl::TrustedAuthority issuer(folder);
  const auto pem = ReadSmallFile(out / "robot.crt");
  ASSERT_TRUE(pem.ok());
  std::atomic<int> asked = 0;
  std::atomic<int> malformed = 0;
  std::vector<std::jthread> askers;
  for (int i = 0; i < 3; ++i) {
    askers.emplace_back([&](const std::stop_token& end) {
      while (!end.stop_requested()) {
        const auto checked = CheckPeerCertificate(*pem, issuer, Now());
        if (!checked && checked.error().code != ErrorCode::kDenied) ++malformed;
        ++asked;
      }
    });
  }
  ASSERT_TRUE(EventuallyTrue([&] { return asked > 0; }));

  ASSERT_TRUE(authority->Revoke("robot").ok());

  const auto checked = CheckPeerCertificate(*pem, issuer, Now());
  EXPECT_FALSE(checked.ok()) << "it was revoked";
  askers.clear();
  EXPECT_EQ(malformed, 0);
  EXPECT_FALSE(CheckPeerCertificate(*pem, issuer, Now()).ok());
}

}  // namespace
}  // namespace tendon
