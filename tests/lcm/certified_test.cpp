#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>
#include <tendon/base/os/process.h>

#include "gcm_console/system_fixture.h"

namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Starts the programs as on hosts that do not trust their network: each program has its own
/// certificate.
class CertifiedPrograms : public SystemFixture {
 protected:
  using Words = Program::Words;

  void SetUp() override {
    Issue({"init"});
    for (const std::string process : {"gcm", "robot"}) {
      Issue({"issue", process, "--role", "operator", "--process", "--out", keys_});
    }
    Issue({"issue", "anna", "--role", "operator", "--out", keys_});
    Issue({"issue", "vera", "--role", "viewer", "--out", keys_});
    gcm = Start("gcm", "gcm", {"serve"});
    ASSERT_TRUE(EventuallyTrue([this] { return gcm->out().starts_with("GCM at "); })) << gcm->err();
  }

  [[nodiscard]] Words Command(const std::string& program, const std::string& name,
                              const Words& words) const {
    Words all{Binary(program),    "--gcm", address, "--timeout", kTestTimeout, "--certificate",
              CertificateOf(name)};
    all.insert(all.end(), words.begin(), words.end());
    return all;
  }
  [[nodiscard]] std::unique_ptr<Program> Start(const std::string& program, const std::string& name,
                                               const Words& words) const {
    return std::make_unique<Program>(Command(program, name, words), environment_);
  }
  [[nodiscard]] Outcome Run(const std::string& program, const std::string& name,
                            const Words& words) const {
    return RunProgram(Command(program, name, words), environment_);
  }
  void Issue(const Words& words) const {
    Words all{Binary("gcm"), "cert"};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome outcome = RunProgram(all, environment_);
    ASSERT_EQ(outcome.exit_code, program::kOk) << outcome.err;
  }
  [[nodiscard]] std::string CertificateOf(const std::string& name) const {
    return keys_ + "/" + name + ".crt";
  }

  const std::string keys_ = (home.path() / "keys").string();
  const std::map<std::string, std::string> environment_{{"XDG_STATE_HOME", home.path().string()}};
};

TEST_F(CertifiedPrograms, AnOperatorMayCallAndAViewerMayNot) {
  const auto robot = Start("lcm", "robot", {"--name", "robot", "--system", demo});
  const Words stop{"call", "robot/arm/Control.Stop"};
  ASSERT_TRUE(EventuallyTrue([&] { return Run("gcm", "anna", stop).exit_code == program::kOk; }))
      << robot->err();

  const Outcome looked = Run("gcm", "vera", {"ls", "robot"});
  const Outcome refused = Run("gcm", "vera", stop);

  EXPECT_EQ(looked.exit_code, program::kOk) << looked.err;
  EXPECT_THAT(looked.out, HasSubstr("arm"));
  EXPECT_EQ(refused.exit_code, program::kDenied);
  EXPECT_THAT(refused.err,
              HasSubstr("'vera (gcm call of " + tendon::os::UserAtHost() + ")' is a viewer here"));
}

TEST_F(CertifiedPrograms, AProcessCannotJoinUnderAnotherName) {
  const Outcome outcome = Run("lcm", "anna", {"--name", "robot", "--system", demo});

  EXPECT_EQ(outcome.exit_code, program::kDenied);
  EXPECT_THAT(outcome.err, HasSubstr("'anna (robot)' cannot join as process 'robot'"));
  EXPECT_TRUE(EventuallyTrue([this] {
    return gcm->err().find("): join as 'robot': refused") != std::string::npos;
  })) << gcm->err();
  EXPECT_THAT(gcm->err(), HasSubstr("audit: anna (robot) (operator, 127.0.0.1:"));
}

TEST_F(CertifiedPrograms, AGcmNeedsItsOwnCertificate) {
  const Outcome outcome = Run("gcm", "robot", {"serve"});

  EXPECT_EQ(outcome.exit_code, program::kDenied);
  EXPECT_THAT(outcome.err, HasSubstr("a GCM needs the certificate of a process 'gcm'"));
}

TEST_F(CertifiedPrograms, TheEnvironmentCanNameTheCertificate) {
  auto environment = environment_;
  environment["TENDON_CERTIFICATE"] = CertificateOf("vera");
  environment["TENDON_CA"] = (home.path() / "tendon" / "ca").string();
  const Words ls{Binary("gcm"), "--gcm", address, "--timeout", kTestTimeout, "ls"};

  EXPECT_EQ(RunProgram(ls, environment).exit_code, program::kOk);
  environment["TENDON_CA"] = home.path().string();
  const Outcome elsewhere = RunProgram(ls, environment);
  EXPECT_EQ(elsewhere.exit_code, program::kNotFound) << elsewhere.err;
}

TEST_F(CertifiedPrograms, RejectsContradictoryOptions) {
  const auto plain = [this](const Words& words) {
    Words all{Binary("gcm"), "--gcm", address};
    all.insert(all.end(), words.begin(), words.end());
    return RunProgram(all, environment_);
  };

  const Outcome insecure = Run("gcm", "vera", {"--insecure", "ls"});
  const Outcome sockets = Run("gcm", "vera", {"--middleware", "tcp", "ls"});
  const Outcome nothing = plain({"--certificate", "", "ls"});

  EXPECT_EQ(insecure.exit_code, program::kUsage);
  EXPECT_THAT(insecure.err, AllOf(HasSubstr("--insecure"), HasSubstr("--certificate")));
  EXPECT_EQ(sockets.exit_code, program::kUsage);
  EXPECT_THAT(sockets.err, HasSubstr("middleware 'tcp' has no TLS"));
  EXPECT_EQ(nothing.exit_code, program::kUsage);
  EXPECT_THAT(nothing.err, HasSubstr("--certificate is empty"));
}

}  // namespace
