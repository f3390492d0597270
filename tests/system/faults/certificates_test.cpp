#include <tendon/security/authority_folder.h>
#include <tendon/security/certificate_authority.h>
#include <tendon/security/certificate_builder.h>
#include <tendon/security/pem.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>

#include "system/faults/harness/fault_test.h"

namespace faults {
namespace {

namespace fs = std::filesystem;
using tendon::CertificateAuthority;
using tendon::Holder;
using tendon::Role;
using testing::HasSubstr;

/// A GCM under TLS, and a CA that makes any certificate that a test needs.
class Certificates : public FaultTest {
 protected:
  using Request = CertificateAuthority::Request;

  Certificates() {
    more_environment_ = {{"TENDON_CA", authority_->folder()}, {"TENDON_CERTIFICATE", Anna()}};
  }

  /// Returns the file of a new certificate, from `authority` or, by default, from the CA of the
  /// test.
  [[nodiscard]] fs::path Issue(const Request& request) const {
    return Issue(request, *authority_, "issued");
  }
  [[nodiscard]] fs::path Issue(const Request& request, const CertificateAuthority& authority,
                               const std::string& folder) const {
    const auto issued = authority.Issue(request, home_.path() / folder);
    EXPECT_TRUE(issued.ok()) << (issued.ok() ? "" : issued.error().message);
    return issued.ok() ? issued->certificate_file : fs::path();
  }
  [[nodiscard]] static Request ProcessNamed(const std::string& name) {
    return {.name = name, .role = Role::kOperator, .holder = Holder::kProcess};
  }
  /// Returns the file of a certificate that expired a minute ago.
  [[nodiscard]] fs::path Expired(const std::string& name) const {
    fs::path file = Issue(ProcessNamed(name));
    const auto key = tendon::ReadPrivateKey(fs::path(file).replace_extension(".key"));
    const auto ca = tendon::ReadAuthority({authority_->folder()});
    const auto ca_key = tendon::ReadPrivateKey(authority_->folder() / "ca.key");
    const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    const auto made = tendon::openssl::MakeCertificate(
        ProcessNamed(name), **key, now - std::chrono::minutes(1), {**ca, **ca_key});
    home_.Write("issued/" + name + ".crt", tendon::openssl::PemOf(*made));
    return file;
  }
  /// Replaces all certificates with this name by a new one.
  void Renew(const Request& request) const {
    const fs::path renewed = Issue(request, *authority_, "renewed");
    for (const char* extension : {".key", ".crt"}) {
      fs::path file = renewed;
      file.replace_extension(extension);
      fs::rename(file, home_.path() / "issued" / file.filename());
    }
  }

  void Serve() {
    gcm_ = std::make_unique<Program>(Command("gcm", {"serve", "--certificate", gcm_certificate_}),
                                     environment());
    ASSERT_TRUE(Eventually([this] { return gcm_->out().starts_with("GCM at "); })) << gcm_->err();
  }
  [[nodiscard]] std::unique_ptr<Program> Run(const std::string& name, const fs::path& certificate,
                                             const fs::path& authority = {}) const {
    Words words{"--name", name, "--certificate", certificate};
    if (!authority.empty()) words.insert(words.end(), {"--ca", authority});
    return std::make_unique<Program>(Command("lcm", words), environment());
  }
  [[nodiscard]] bool IsListed(const std::string& process) const {
    return Gcm({"ls"}).out.find(process + "\talive") != std::string::npos;
  }

  /// Connects by TLS with all files of a certificate, without a program of Tendon.
  void Knock(const fs::path& certificate) const {
    const std::string script = "echo hello | timeout 10 openssl s_client -connect " + gcm_address_ +
                               " -cert " + certificate.string() + " -key " +
                               fs::path(certificate).replace_extension(".key").string();
    RunProgram({"/bin/sh", "-c", script});
  }

  /// A program with an invalid certificate, and the expected messages.
  struct Row {
    std::string what;
    std::string name;  // the name under which the program joins
    fs::path certificate;
    fs::path authority;
    std::string own_words;
    std::string words_of_gcm;
  };
  [[nodiscard]] std::vector<Row> Matrix() const {
    const auto elsewhere = CertificateAuthority::Init(home_.path() / "elsewhere");
    const fs::path revoked = Issue(ProcessNamed("revoked"));
    EXPECT_TRUE(authority_->Revoke("revoked").ok());
    return {{"expired", "expired", Expired("expired"), {}, "expired on", "certificate has expired"},
            {"revoked",
             "revoked",
             revoked,
             {},
             "was revoked",
             "the certificate of 'revoked' was revoked"},
            {"of another CA", "robot", Issue(ProcessNamed("robot"), *elsewhere, "mallory"),
             elsewhere->folder(), "its certificate was not issued by the CA in",
             "certificate verification failure"},
            {"of another process",
             "robot",
             Issue(ProcessNamed("arm")),
             {},
             "'arm (robot)' cannot join as process 'robot'",
             "join as 'robot': refused"},
            {"of a person",
             "bob",
             Issue({.name = "bob", .role = Role::kOperator}),
             {},
             "cannot join as process 'bob'",
             "join as 'bob': refused"},
            {"of a viewer",
             "eye",
             Issue({.name = "eye", .role = Role::kViewer, .holder = Holder::kProcess}),
             {},
             "needs the role operator, but 'eye' is a viewer",
             "eye (viewer"}};
  }

  const tendon::Result<CertificateAuthority> authority_ =
      CertificateAuthority::Init(home_.path() / "ca");
  const fs::path gcm_certificate_ = Issue(ProcessNamed("gcm"));

 private:
  [[nodiscard]] fs::path Anna() const { return Issue({.name = "anna", .role = Role::kOperator}); }
};

/// Returns the middlewares; TLS needs Ice.
std::vector<std::string> MiddlewaresUnderTls() {
  std::vector<std::string> all = Middlewares();
  std::erase_if(all, [](const std::string& name) { return name != "ice"; });
  return all;
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Certificates);
INSTANTIATE_TEST_SUITE_P(Over, Certificates, testing::ValuesIn(MiddlewaresUnderTls()),
                         NameOfMiddleware);

/// Checks the messages of a program with an invalid certificate, and the message of the GCM about a
/// program that does not check its own certificate.
TEST_P(Certificates, BothSidesReportARejectedCertificate) {
  ASSERT_NO_FATAL_FAILURE(Serve());
  const fs::path open_key = Issue(ProcessNamed("open"));
  fs::permissions(fs::path(open_key).replace_extension(".key"), fs::perms::others_read,
                  fs::perm_options::add);
  const std::vector<Row> matrix = Matrix();

  for (const Row& row : matrix) {
    SCOPED_TRACE(row.what);
    const auto lcm = Run(row.name, row.certificate, row.authority);
    EXPECT_NE(lcm->Wait().value_or(0), 0) << lcm->err();
    EXPECT_THAT(lcm->err(), HasSubstr(row.own_words));
    Knock(row.certificate);
    EXPECT_TRUE(Eventually([&] { return gcm_->err().find(row.words_of_gcm) != std::string::npos; }))
        << gcm_->err();
  }
  const auto careless = Run("open", open_key);
  EXPECT_NE(careless->Wait().value_or(0), 0);
  EXPECT_THAT(careless->err(), HasSubstr("chmod"));
  EXPECT_FALSE(IsListed("robot"));

  robot_ = Run("robot", Issue(ProcessNamed("robot")));
  EXPECT_TRUE(Eventually([this] { return IsListed("robot"); })) << robot_->err();
  Tell(std::to_string(matrix.size() + 1) + " kinds of certificates were refused, a good one not");
}

TEST_P(Certificates, ARenewedCertificateIsUsedWithoutARestart) {
  ASSERT_NO_FATAL_FAILURE(Serve());
  robot_ = Run("robot", Issue(ProcessNamed("robot")));
  ASSERT_TRUE(Eventually([this] { return IsListed("robot"); })) << robot_->err();
  ASSERT_TRUE(authority_->Revoke("gcm").ok());
  ASSERT_TRUE(authority_->Revoke("robot").ok());
  const Outcome refused = Gcm({"ls"});
  EXPECT_THAT(refused.err, HasSubstr("the certificate of 'gcm' was revoked"));

  Renew(ProcessNamed("gcm"));
  const Stopwatch since_renewed;
  EXPECT_TRUE(Eventually([this] { return IsListed("robot"); }));
  const long listed_after = since_renewed.milliseconds();
  if (!MayExpireLeases()) {
    EXPECT_EQ(robot_->err().find("was lost"), std::string::npos) << "its link is as it was";
  }

  gcm_->Signal(SIGKILL);
  gcm_->Wait();
  Serve();
  EXPECT_TRUE(Eventually([this] {
    return gcm_->err().find("the certificate of 'robot' was revoked") != std::string::npos;
  })) << "it shows the one before";
  Renew(ProcessNamed("robot"));
  const Stopwatch since_its_own;
  EXPECT_TRUE(Eventually([this] { return IsListed("robot"); })) << robot_->err();
  const long joined_after = since_its_own.milliseconds();

  Tell("the GCM showed its new one after " + std::to_string(listed_after) +
       " ms, the robot its own after " + std::to_string(joined_after) + " ms");
  if (MayExpireLeases()) return;
  constexpr double kGoal = 5000;
  EXPECT_LE(static_cast<double>(listed_after), kGoal * Slowness());
  EXPECT_LE(static_cast<double>(joined_after), kGoal * Slowness());
}

}  // namespace
}  // namespace faults
