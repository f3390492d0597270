#include <gmock/gmock.h>
#include <tendon/security/certificate_authority.h>

#include <fstream>
#include <iterator>
#include <vector>

#include "core/security/authority.h"

namespace tendon {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class CertificateAuthorityTest : public AuthorityTest {};

void ExpectRefused(const auto& result, ErrorCode code, const std::string& sentence) {
  ASSERT_FALSE(result.ok()) << sentence;
  EXPECT_EQ(result.error().code, code) << result.error().message;
  EXPECT_THAT(result.error().message, HasSubstr(sentence));
}

TEST_F(CertificateAuthorityTest, ItsFolderIsPrivate) {
  ASSERT_TRUE(authority.ok()) << authority.error().message;
  Issue({.name = "robot", .holder = Holder::kProcess});
  ASSERT_TRUE(authority->Revoke("robot").ok());

  EXPECT_EQ(ModeOf(folder), 0700U);
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    EXPECT_EQ(ModeOf(entry.path()), entry.is_directory() ? 0700U : 0600U) << entry.path();
    files += entry.is_directory() ? 0U : 1U;
  }
  EXPECT_EQ(files, 4U);  // no lock file remains
  EXPECT_EQ(ModeOf(out / "robot.key"), 0600U);
}

TEST_F(CertificateAuthorityTest, LastsTenYears) {
  EXPECT_GT(authority->not_after(), Now() + std::chrono::days(3651));
  EXPECT_LE(authority->not_after(), Now() + std::chrono::years(10));
}

TEST_F(CertificateAuthorityTest, DoesNotOverwriteAnotherCa) {
  const std::string key = home.Read("ca/ca.key");

  ExpectRefused(CertificateAuthority::Init(folder), ErrorCode::kExists, "there is a CA in");

  EXPECT_EQ(home.Read("ca/ca.key"), key);
}

TEST_F(CertificateAuthorityTest, RefusesAnIncompleteCa) {
  fs::remove(folder / "ca.crt");

  ExpectRefused(CertificateAuthority::Init(folder), ErrorCode::kExists,
                "is incomplete, because the file ca.crt is missing");
  ExpectRefused(CertificateAuthority::Open(folder), ErrorCode::kNotFound, "there is no CA in");
}

TEST_F(CertificateAuthorityTest, RefusesAFolderWithOtherFiles) {
  home.Write("letter", "");

  ExpectRefused(CertificateAuthority::Init(home.path()), ErrorCode::kExists,
                "contains other files");
}

TEST_F(CertificateAuthorityTest, IssuesACertificateWithNameAndRole) {
  const auto issued =
      Issue({.name = "anna", .role = Role::kOperator, .validity = std::chrono::days(7)});

  const auto read = ParseCertificate(home.Read("out/anna.crt"));
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(*read, issued.certificate);
  EXPECT_EQ(read->name, "anna");
  EXPECT_EQ(read->role, Role::kOperator);
  EXPECT_EQ(read->holder, Holder::kPerson);
  EXPECT_LT(read->not_before, Now());
  EXPECT_GT(read->not_after, Now() + std::chrono::days(6));
  EXPECT_LE(read->not_after, Now() + std::chrono::days(7));
  EXPECT_GE(read->serial.size(), 30U);
}

TEST_F(CertificateAuthorityTest, CertificatesOfOneNameDifferInSerialAndKey) {
  const auto first = Issue({.name = "robot"});
  const auto second = authority->Issue({.name = "robot"}, home.path() / "next");

  ASSERT_TRUE(second.ok()) << second.error().message;
  EXPECT_NE(first.certificate.serial, second->certificate.serial);
  EXPECT_NE(home.Read("out/robot.key"), home.Read("next/robot.key"));
}

TEST_F(CertificateAuthorityTest, DoesNotOverwriteFiles) {
  Issue({.name = "robot"});
  const std::string key = home.Read("out/robot.key");

  ExpectRefused(authority->Issue({.name = "robot"}, out), ErrorCode::kExists,
                "robot.crt already exists, and is not overwritten: choose another folder");
  fs::remove(out / "robot.crt");
  ExpectRefused(authority->Issue({.name = "robot"}, out), ErrorCode::kExists,
                "robot.key already exists");

  EXPECT_EQ(home.Read("out/robot.key"), key);
  EXPECT_FALSE(fs::exists(out / "robot.crt"));
}

TEST_F(CertificateAuthorityTest, RefusesInvalidRequests) {
  const std::vector<std::pair<Request, std::string>> cases = {
      {{.name = ""}, "certificate name is empty"},
      {{.name = "../robot"}, "certificate name '../robot' has '.' at 1"},
      {{.name = "robot\n"}, "certificate name"},
      {{.name = std::string(65, 'a')}, "max 64"},
      {{.name = "a", .hosts = {""}}, "host ''"},
      {{.name = "a", .hosts = {"b,DNS:evil"}}, "host 'b,DNS:evil'"},
      {{.name = "a", .hosts = {"*.local"}}, "host '*.local'"},
      {{.name = "a", .validity = std::chrono::days(0)}, "at least 1 day"},
      {{.name = "a", .validity = std::chrono::days(3660)}, "would outlive its CA"},
  };
  for (const auto& [request, sentence] : cases) {
    ExpectRefused(authority->Issue(request, out), ErrorCode::kInvalid, sentence);
  }
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(CertificateAuthorityTest, RevokesAllCertificatesOfAName) {
  const auto first = Issue({.name = "robot"});
  const auto second = authority->Issue({.name = "robot"}, home.path() / "next");
  Issue({.name = "desk"});
  ASSERT_TRUE(second.ok()) << second.error().message;

  const auto revoked = authority->Revoke("robot");

  ASSERT_TRUE(revoked.ok()) << revoked.error().message;
  EXPECT_THAT(*revoked,
              testing::UnorderedElementsAre(first.certificate.serial, second->certificate.serial));
  ExpectRefused(authority->Revoke("robot"), ErrorCode::kExists, "are already revoked");
}

TEST_F(CertificateAuthorityTest, RevokesNothingIfACopyIsUnreadable) {
  Issue({.name = "robot"});
  const auto second = authority->Issue({.name = "robot"}, home.path() / "next");
  ASSERT_TRUE(second.ok()) << second.error().message;
  const std::string copy = "issued/" + second->certificate.serial + ".crt";
  const std::string revoked = home.Read("ca/crl.pem");
  home.Write("ca/" + copy, "");

  ExpectRefused(authority->Revoke("robot"), ErrorCode::kInvalid, copy + " cannot be read");

  EXPECT_EQ(home.Read("ca/crl.pem"), revoked);
}

TEST_F(CertificateAuthorityTest, RevokesDespiteAnUnfinishedCopy) {
  Issue({.name = "robot"});
  home.Write("ca/issued/1234.crt.new", "-----BEGIN");

  EXPECT_TRUE(authority->Revoke("robot").ok());
}

TEST_F(CertificateAuthorityTest, ReportsANameWithoutCertificates) {
  Issue({.name = "robot"});

  ExpectRefused(authority->Revoke("robto"), ErrorCode::kNotFound, "did you mean 'robot'?");
}

TEST_F(CertificateAuthorityTest, RefusesItsKeyIfReadableByOthers) {
  fs::permissions(folder / "ca.key", fs::perms(0640));

  const auto opened = CertificateAuthority::Open(folder);

  ExpectRefused(opened, ErrorCode::kDenied, "can be read by others (mode 0640): chmod 600 ");
  ExpectRefused(authority->Issue({.name = "robot"}, out), ErrorCode::kDenied, "ca.key");
}

TEST_F(CertificateAuthorityTest, RefusesAForeignKey) {
  ASSERT_TRUE(CertificateAuthority::Init(home.path() / "other").ok());
  fs::copy_file(home.path() / "other" / "ca.key", folder / "ca.key",
                fs::copy_options::overwrite_existing);

  ExpectRefused(CertificateAuthority::Open(folder), ErrorCode::kInvalid, "does not belong to");
}

TEST_F(CertificateAuthorityTest, ReportsAMissingCa) {
  ExpectRefused(
      CertificateAuthority::Open(home.path() / "nowhere"), ErrorCode::kNotFound,
      "to make a CA: gcm cert init; if the CA is in another folder, give that folder with --ca");
}

TEST_F(CertificateAuthorityTest, AllowsOneChangeAtATime) {
  home.Write("ca/lock", "somebody");
  fs::permissions(folder / "lock", fs::perms(0600));

  ExpectRefused(authority->Issue({.name = "robot"}, out), ErrorCode::kFailed, "try again");
  ExpectRefused(authority->Revoke("robot"), ErrorCode::kFailed, "remove " + folder.string());
  EXPECT_EQ(home.Read("ca/lock"), "somebody");
}

}  // namespace
}  // namespace tendon
