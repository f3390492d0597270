#pragma once

#include <gtest/gtest.h>
#include <tendon/security/certificate_authority.h>

#include <chrono>
#include <filesystem>
#include <string>

#include "support/folder.h"

namespace tendon {

/// A CA in its own folder, and the folder of the certificates that it issues.
class AuthorityTest : public testing::Test {
 protected:
  using Request = CertificateAuthority::Request;

  /// Issues a certificate. The test fails if the request is refused.
  CertificateAuthority::IssuedCertificate Issue(const Request& request) const {
    auto issued = authority->Issue(request, out);
    EXPECT_TRUE(issued.ok()) << (issued.ok() ? "" : issued.error().message);
    return issued.ok() ? *issued : CertificateAuthority::IssuedCertificate();
  }
  static std::chrono::sys_seconds Now() {
    return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  }
  static unsigned ModeOf(const std::filesystem::path& file) {
    return static_cast<unsigned>(std::filesystem::status(file).permissions());
  }

  const test::Folder home;
  const std::filesystem::path folder = home.path() / "ca";
  const std::filesystem::path out = home.path() / "out";
  const Result<CertificateAuthority> authority = CertificateAuthority::Init(folder);
};

}  // namespace tendon
