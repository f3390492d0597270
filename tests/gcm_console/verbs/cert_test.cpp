#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "support/folder.h"
#include "support/program.h"

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

/// Runs `gcm cert ...` as a user types it. The CA is in its default folder.
class CertTest : public testing::Test {
 protected:
  Outcome Cert(Program::Words words) const {
    words.insert(words.begin(), {Built("bin/gcm"), "cert"});
    return RunProgram(words, {{"XDG_STATE_HOME", home.path().string()}});
  }
  /// Runs a subcommand that must succeed.
  void Must(const Program::Words& words) const {
    const Outcome outcome = Cert(words);
    EXPECT_EQ(outcome.exit_code, program::kOk) << outcome.err;
  }
  void MakeRobot() const {
    Must({"init"});
    Must({"issue", "robot", "--role", "operator", "--process", "--host", "robot.local", "--host",
          "192.168.0.7", "--out", out});
  }
  void ExpectRefused(const Program::Words& words, int exit_code,
                     const std::string& sentence) const {
    const Outcome outcome = Cert(words);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
    EXPECT_THAT(outcome.err, testing::StartsWith("gcm: "));
    EXPECT_THAT(outcome.err, HasSubstr(sentence));
    EXPECT_EQ(outcome.out, "");
  }

  const tendon::test::Folder home;
  const fs::path ca = home.path() / "tendon" / "ca";
  const std::string out = (home.path() / "out").string();
  const std::string robot = out + "/robot.crt";
};

TEST_F(CertTest, CreatesACaAndAValidCertificate) {
  const Outcome made = Cert({"init"});
  EXPECT_EQ(made.exit_code, program::kOk) << made.err;
  EXPECT_THAT(made.out, testing::StartsWith("CA in " + ca.string() + ", valid until 20"));
  Must({"issue", "anna", "--role", "viewer", "--out", out});

  const Outcome checked = Cert({"check", out + "/anna.crt"});

  EXPECT_EQ(checked.exit_code, program::kOk);
  EXPECT_EQ(checked.err, "");
  EXPECT_THAT(checked.out, testing::StartsWith("name\tanna\nrole\tviewer\nholder\tperson\n"));
  EXPECT_THAT(checked.out, HasSubstr("key\t" + out + "/anna.key\n"));
}

TEST_F(CertTest, ADryRunListsFilesAndCreatesNone) {
  EXPECT_EQ(Cert({"init", "--dry-run"}).out, "the CA would be made in " + ca.string() + "\n");
  EXPECT_EQ(json::parse(Cert({"init", "--dry-run", "--json"}).out)["dry_run"], true);
  EXPECT_FALSE(fs::exists(ca));

  Must({"init"});
  ExpectRefused({"init", "--dry-run"}, program::kRefused, "there is a CA in");
  const Program::Words issue = {"issue", "anna", "--role", "viewer", "--out", out};
  Program::Words rehearsed = issue;
  rehearsed.emplace_back("--dry-run");
  EXPECT_EQ(Cert(rehearsed).out,
            out + "/anna.crt  would be written\n" + out + "/anna.key  would be written\n");
  EXPECT_FALSE(fs::exists(out));
  ExpectRefused({"issue", "a b", "--role", "viewer", "--dry-run"}, program::kUsage, "'a b'");
  Must(issue);
  ExpectRefused(rehearsed, program::kRefused, "already exists");

  const Outcome revoked = Cert({"revoke", "anna", "--dry-run"});
  EXPECT_THAT(revoked.out, testing::MatchesRegex("anna  would be revoked  [0-9a-fA-F:]+\n"));
  EXPECT_EQ(Cert({"check", out + "/anna.crt"}).exit_code, program::kOk) << "it is good still";
  ExpectRefused({"revoke", "ana", "--dry-run"}, program::kNotFound, "did you mean 'anna'?");
  EXPECT_EQ("anna  revoked  " + revoked.out.substr(revoked.out.rfind(' ') + 1),
            Cert({"revoke", "anna"}).out);
  ExpectRefused({"revoke", "anna", "--dry-run"}, program::kRefused, "already revoked");
}

TEST_F(CertTest, PrintsJson) {
  const json made = json::parse(Cert({"init", "--json"}).out);
  EXPECT_EQ(made["schema"], 1);
  EXPECT_EQ(made["folder"], ca.string());

  const json issued = json::parse(
      Cert({"--json", "issue", "robot", "--role", "operator", "--process", "--out", out}).out);
  EXPECT_EQ(issued["name"], "robot");
  EXPECT_EQ(issued["role"], "operator");
  EXPECT_EQ(issued["holder"], "process");
  EXPECT_EQ(issued["certificate"], robot);

  json checked = json::parse(Cert({"check", robot, "--json"}).out);
  EXPECT_EQ(checked["warning"], "");
  EXPECT_EQ(checked["serial"], issued["serial"]);
  EXPECT_EQ(checked["key"], issued["key"]);

  const json revoked = json::parse(Cert({"revoke", "robot", "--json"}).out);
  EXPECT_EQ(revoked["revoked"], json::array({issued["serial"]}));
  EXPECT_EQ(revoked["list"], (ca / "crl.pem").string());
}

TEST_F(CertTest, WarnsOfACertificateThatExpiresSoon) {
  Must({"init"});
  Must({"issue", "guest", "--role", "viewer", "--days", "3", "--out", out});

  const Outcome checked = Cert({"check", out + "/guest.crt"});

  EXPECT_EQ(checked.exit_code, program::kOk);
  EXPECT_THAT(checked.err, HasSubstr("guest.crt expires on "));
  EXPECT_THAT(checked.err, HasSubstr("issue another with gcm cert issue"));
}

TEST_F(CertTest, RejectsARevokedCertificate) {
  MakeRobot();
  const Outcome revoked = Cert({"revoke", "robot"});
  EXPECT_EQ(revoked.exit_code, program::kOk) << revoked.err;
  EXPECT_THAT(revoked.out, testing::StartsWith("robot  revoked  "));
  EXPECT_THAT(revoked.err, HasSubstr((ca / "crl.pem").string()));

  ExpectRefused({"check", robot}, program::kDenied, "was revoked");
  ExpectRefused({"revoke", "robot"}, program::kRefused, "already revoked");
  ExpectRefused({"revoke", "robbi"}, program::kNotFound, "no certificate to 'robbi'");
}

TEST_F(CertTest, ChecksWithThePublicFilesOnly) {
  MakeRobot();
  const fs::path copy = home.path() / "copy";
  fs::create_directory(copy);
  for (const char* file : {"ca.crt", "crl.pem"}) fs::copy_file(ca / file, copy / file);

  Must({"check", robot, "--ca", copy.string()});
  Must({"--ca", copy.string(), "check", robot});

  ExpectRefused({"issue", "eve", "--role", "operator", "--ca", copy.string(), "--out", out},
                program::kNotFound, "ca.key");
}

TEST_F(CertTest, RejectsAKeyFileReadableByOthers) {
  MakeRobot();
  fs::permissions(out + "/robot.key", fs::perms(0644));

  ExpectRefused({"check", robot}, program::kDenied,
                "can be read by others (mode 0644): chmod 600 " + out + "/robot.key");
}

TEST_F(CertTest, ExplainsCommandLineMistakes) {
  ExpectRefused({}, program::kUsage, "a verb is missing; gcm cert --help tells more");
  ExpectRefused({"isue"}, program::kUsage,
                "no verb 'isue'; did you mean 'issue'? to list the verbs: gcm cert --help");
  ExpectRefused({"issue", "a"}, program::kUsage, "--role is missing; gcm cert issue --help");
  ExpectRefused({"issue", "a", "--role", "viewer", "--proces"}, program::kUsage,
                "no option '--proces'; did you mean '--process'? gcm cert issue --help");
  ExpectRefused({"issue", "a", "--role", "viewer", "--host", "b"}, program::kUsage, "--process");
  ExpectRefused({"--days", "5", "issue", "a"}, program::kUsage,
                "option '--days' is in the wrong place; gcm cert issue --help tells more");
  ExpectRefused({"issue", "a", "--role", "root"}, program::kUsage,
                "role 'root': expected viewer or operator");
  ExpectRefused({"issue", "a", "--role", "viewer", "--days", "0"}, program::kUsage, "--days");
  ExpectRefused({"issue", "a", "--role", "viewer"}, program::kNotFound, "gcm cert init");
  ExpectRefused({"check", "nothing.crt"}, program::kNotFound, "there is no file nothing.crt");
}

/// Searches the output for the lines of the key file. A secret inside another line of base64 could
/// not be recognised.
TEST_F(CertTest, NeverPrintsAKey) {
  Must({"init"});
  std::string said;
  for (const Program::Words& words :
       {Program::Words{"issue", "robot", "--role", "viewer", "--out", out},
        {"check", robot},
        {"check", out + "/robot.key"},
        {"check", (ca / "ca.key").string()},
        {"revoke", "robot"}}) {
    const Outcome outcome = Cert(words);
    said += outcome.out + outcome.err;
  }

  for (const std::string& file : {out + "/robot.key", (ca / "ca.key").string()}) {
    std::ifstream key(file);
    for (std::string line; std::getline(key, line);) {
      EXPECT_EQ(said.find(line), std::string::npos) << line;
    }
  }
  EXPECT_THAT(said, HasSubstr("contains a private key"));
}

/// Checks certificates of `gcm cert` with openssl(1).
class CertOracleTest : public CertTest {
 protected:
  void SetUp() override {
    if (std::string(TENDON_OPENSSL).empty()) GTEST_SKIP() << "openssl(1) is not on this machine";
    MakeRobot();
  }
  static Outcome OpenSsl(Program::Words words) {
    words.insert(words.begin(), TENDON_OPENSSL);
    return RunProgram(words);
  }
  [[nodiscard]] Outcome Verify(const std::string& file, const std::string& purpose) const {
    return OpenSsl({"verify", "-x509_strict", "-crl_check", "-CAfile", ca / "ca.crt", "-CRLfile",
                    ca / "crl.pem", "-purpose", purpose, file});
  }
  /// Makes made.crt and made.key. They are signed with the CA's key, but violate the rules of the
  /// CA.
  void Make(const std::string& subject) const {
    std::ofstream(out + "/extensions") << "basicConstraints=critical,CA:FALSE\n"
                                          "keyUsage=critical,digitalSignature\n"
                                          "extendedKeyUsage=clientAuth\n"
                                          "subjectKeyIdentifier=hash\n"
                                          "authorityKeyIdentifier=keyid:always\n";
    const std::string request = out + "/request";
    ASSERT_EQ(OpenSsl({"req", "-newkey", "rsa:2048", "-nodes", "-keyout", out + "/made.key",
                       "-subj", subject, "-out", request})
                  .exit_code,
              0);
    ASSERT_EQ(OpenSsl({"x509", "-req", "-in", request, "-CA", ca / "ca.crt", "-CAkey",
                       ca / "ca.key", "-CAcreateserial", "-CAserial", out + "/serial", "-extfile",
                       out + "/extensions", "-out", out + "/made.crt"})
                  .exit_code,
              0);
  }
};

TEST_F(CertOracleTest, OpensslVerifiesIssuedCertificates) {
  Must({"issue", "anna", "--role", "viewer", "--out", out});

  EXPECT_EQ(Verify(robot, "sslserver").exit_code, 0) << Verify(robot, "sslserver").err;
  EXPECT_EQ(Verify(robot, "sslclient").exit_code, 0);
  EXPECT_EQ(Verify(out + "/anna.crt", "sslclient").exit_code, 0);
  EXPECT_NE(Verify(out + "/anna.crt", "sslserver").exit_code, 0);
}

TEST_F(CertOracleTest, OpensslReadsTheSameFields) {
  const Outcome text = OpenSsl({"x509", "-in", robot, "-noout", "-subject", "-serial", "-ext",
                                "subjectAltName", "-nameopt", "RFC2253"});

  EXPECT_THAT(text.out, HasSubstr("subject=CN=robot,OU=operator,O=Tendon"));
  EXPECT_THAT(text.out, HasSubstr("DNS:robot.local, IP Address:192.168.0.7"));
  const json checked = json::parse(Cert({"check", robot, "--json"}).out);
  EXPECT_THAT(text.out, HasSubstr("serial=" + checked["serial"].get<std::string>()));
}

TEST_F(CertOracleTest, OpensslSeesTheRevocation) {
  Must({"revoke", "robot"});

  const Outcome verified = Verify(robot, "sslclient");

  EXPECT_NE(verified.exit_code, 0);
  EXPECT_THAT(verified.err, HasSubstr("certificate revoked"));
}

TEST_F(CertOracleTest, AcceptsOpensslCertificatesWithExactlyOneRole) {
  Make("/O=Tendon/OU=operator/CN=eve");
  Must({"check", out + "/made.crt"});

  Make("/O=Tendon/OU=root/CN=eve");
  ExpectRefused({"check", out + "/made.crt"}, program::kDenied,
                "made.crt: role 'root': expected viewer or operator");
  Make("/O=Tendon/CN=eve");
  ExpectRefused({"check", out + "/made.crt"}, program::kDenied, "made.crt: role ''");
  Make("/O=Tendon/OU=viewer/OU=operator/CN=eve");
  ExpectRefused({"check", out + "/made.crt"}, program::kDenied, "made.crt: role ''");
  Make("/O=Tendon/OU=operator/CN=e ve");
  ExpectRefused({"check", out + "/made.crt"}, program::kDenied, "certificate name 'e ve' has ' '");
}

TEST_F(CertOracleTest, RejectsASelfSignedCertificate) {
  const std::string made = out + "/made.crt";
  ASSERT_EQ(OpenSsl({"req", "-x509", "-newkey", "rsa:2048", "-nodes", "-keyout", out + "/made.key",
                     "-subj", "/CN=robot/OU=operator", "-out", made})
                .exit_code,
            0);

  ExpectRefused({"check", made}, program::kDenied, "was not issued by the CA");
}

}  // namespace
