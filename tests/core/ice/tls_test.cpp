#include <tendon/base/os/socket.h>
#include <tendon/ice/pending_tls_handshakes.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "core/ice/tls_fixture.h"

namespace tendon::ice {
namespace {

using testing::HasSubstr;

TEST_F(TlsTest, TheOpenerLearnsTheAcceptorsIdentity) {
  const auto anna = As({.name = "anna"});

  const auto channel = Open(anna, Listen(robot_, "robot"), "gcm ls", "robot");

  ASSERT_TRUE(channel.ok()) << channel.error().message;
  EXPECT_EQ((*channel)->peer().name, "robot");
  EXPECT_EQ((*channel)->peer().role, Role::kOperator);
}

TEST_F(TlsTest, TheAcceptorReadsNameAndRoleFromTheCertificate) {
  const auto desk = As({.name = "desk", .role = Role::kOperator, .holder = kProcess});
  const auto anna = As({.name = "anna", .role = Role::kViewer});

  EXPECT_EQ(Guest(desk, "desk").name, "desk");
  EXPECT_EQ(Guest(desk, "desk").role, Role::kOperator);
  EXPECT_EQ(Guest(desk, "gcm").name, "desk (gcm)");
  EXPECT_EQ(Guest(anna, "gcm ls").name, "anna (gcm ls)");
  EXPECT_EQ(Guest(anna, "gcm ls").role, Role::kViewer);
  EXPECT_EQ(Guest(anna, "anna").name, "anna (anna)") << "a person is no process";
}

TEST_F(TlsTest, RefusesANameThatDiffersFromTheCertificate) {
  const auto arm = As({.name = "arm", .role = Role::kOperator, .holder = kProcess});

  const auto refusal = Refusal(robot_, Listen(arm, "gcm"), "gcm");

  EXPECT_EQ(refusal.code, ErrorCode::kDenied);
  EXPECT_THAT(refusal.message,
              HasSubstr("calls itself 'gcm', but shows the certificate of the process 'arm'"));
}

TEST_F(TlsTest, RefusesAnUnexpectedPeer) {
  const auto refusal = Refusal(As({.name = "anna"}), Listen(robot_, "robot"), "gcm");

  EXPECT_EQ(refusal.code, ErrorCode::kUnreachable);
  EXPECT_THAT(refusal.message, HasSubstr("is 'robot', but 'gcm' was expected"));
}

TEST_F(TlsTest, ARevokedOpenerIsRefusedWithTheReason) {
  const auto eve = Issue({.name = "eve", .role = Role::kOperator}).certificate_file;
  const auto uninformed = Showing(eve, CopyOfPublicFiles());
  const auto address = Listen(robot_, "robot");
  ASSERT_TRUE(authority->Revoke("eve").ok());

  const auto own = MakeIceMiddleware(Credentials{.certificate = eve, .authority = folder});
  const auto refusal = Refusal(uninformed, address);

  ASSERT_FALSE(own.ok());
  EXPECT_THAT(own.error().message, HasSubstr("was revoked"));
  EXPECT_EQ(refusal.code, ErrorCode::kUnreachable);
  EXPECT_THAT(refusal.message, HasSubstr("does not accept " + eve.string()));
  EXPECT_TRUE(EventuallyAudited("was refused: the certificate of 'eve' was revoked"));
}

TEST_F(TlsTest, RefusesARevokedAcceptor) {
  const auto arm = As({.name = "arm", .role = Role::kOperator, .holder = kProcess});
  const auto address = Listen(arm, "arm");
  ASSERT_TRUE(Open(robot_, address, "robot").ok());
  ASSERT_TRUE(authority->Revoke("arm").ok());

  const auto refusal = Refusal(robot_, address);

  EXPECT_EQ(refusal.code, ErrorCode::kDenied);
  EXPECT_THAT(refusal.message, HasSubstr("is not trusted: the certificate of 'arm' was revoked"));
}

TEST_F(TlsTest, NeitherEndTrustsAnotherCa) {
  const auto elsewhere = CertificateAuthority::Init(home.path() / "elsewhere");
  const auto mallory = elsewhere->Issue(
      {.name = "robot", .role = Role::kOperator, .holder = kProcess}, home.path() / "mallory");
  const auto impostor = Showing(mallory->certificate_file, elsewhere->folder());

  const auto opened = Refusal(As({.name = "anna"}), Listen(impostor, "robot"));
  const auto accepted = Refusal(impostor, Listen(robot_, "robot"));

  EXPECT_EQ(opened.code, ErrorCode::kDenied);
  EXPECT_THAT(opened.message,
              HasSubstr("its certificate was not issued by the CA in " + folder.string()));
  EXPECT_EQ(accepted.code, ErrorCode::kDenied);
  EXPECT_TRUE(EventuallyAudited("certificate verification failure"));
}

TEST_F(TlsTest, RefusesAPersonAsAcceptor) {
  const auto anna = As({.name = "anna", .role = Role::kOperator});

  const auto refusal = Refusal(robot_, Listen(anna, "anna"));

  EXPECT_EQ(refusal.code, ErrorCode::kDenied);
  EXPECT_THAT(refusal.message, HasSubstr("its certificate belongs to a person"));
}

TEST_F(TlsTest, DoesNotUseAnExpiredCertificate) {
  const auto file = Expiring(std::chrono::minutes(-1));

  const auto own = MakeIceMiddleware(Credentials{.certificate = file, .authority = folder});

  ASSERT_FALSE(own.ok());
  EXPECT_THAT(own.error().message, HasSubstr("expired on "));
}

TEST_F(TlsTest, RefusesACertificateThatExpiresLater) {
  const auto old = Showing(Expiring(std::chrono::seconds(10)));
  const auto address = Listen(old, "old");
  std::string why;

  EXPECT_TRUE(EventuallyTrue([&] {
    const auto channel = Open(robot_, address, "robot");
    if (!channel) why = channel.error().message;
    return !channel;
  }));

  EXPECT_THAT(why, HasSubstr("expired"));
}

TEST_F(TlsTest, RefusesAViewersCertificateFromTheGcm) {
  const auto gcm = As({.name = "gcm", .role = Role::kViewer, .holder = kProcess});

  const auto refusal = Refusal(robot_, Listen(gcm, "gcm"), "gcm");

  EXPECT_EQ(refusal.code, ErrorCode::kDenied);
  EXPECT_THAT(refusal.message, HasSubstr("has the certificate of a viewer"));
}

TEST_F(TlsTest, LogsRefusedPeersAtAnyLogLevel) {
  SetLogLevel(LogLevel::kError);
  const auto address = Listen(robot_, "robot");
  const auto copy = CopyOfPublicFiles();
  for (const std::string name : {"eva", "evi"}) {
    const auto uninformed = Showing(Issue({.name = name}).certificate_file, copy);
    ASSERT_TRUE(authority->Revoke(name).ok());

    (void)Refusal(uninformed, address);

    EXPECT_TRUE(EventuallyAudited("was refused: the certificate of '" + name + "' was revoked"));
  }
  SetLogLevel(LogLevel::kInfo);
}

TEST_F(TlsTest, TrustsNobodyWhileItsCaFilesAreMissing) {
  const auto address = Listen(robot_, "robot");
  const auto anna = Showing(Issue({.name = "anna"}).certificate_file, CopyOfPublicFiles());
  fs::rename(folder / "crl.pem", home.path() / "kept");

  EXPECT_FALSE(Open(anna, address, "gcm").ok());
  fs::rename(home.path() / "kept", folder / "crl.pem");
  EXPECT_TRUE(Open(anna, address, "gcm").ok());
}

TEST_F(TlsTest, RefusesAPeerWithoutACertificate) {
  const std::shared_ptr<Middleware> plain = MakeIceMiddleware(Exposure::kLoopbackOnly);
  const auto address = Listen(robot_, "robot");

  const auto channel =
      plain->Open(address, std::make_shared<Deaf>(), std::chrono::milliseconds(500));

  ASSERT_FALSE(channel.ok());
  EXPECT_EQ(channel.error().code, ErrorCode::kTimeout);
  EXPECT_THAT(channel.error().message, HasSubstr("or requires a --certificate"));
}

TEST_F(TlsTest, RefusesAnAcceptorWithoutTls) {
  const std::shared_ptr<Middleware> plain = MakeIceMiddleware(Exposure::kLoopbackOnly);

  const auto refusal = Refusal(As({.name = "anna"}), Listen(plain, "robot"));

  EXPECT_EQ(refusal.code, ErrorCode::kUnreachable);
  EXPECT_THAT(refusal.message, HasSubstr("or does not use TLS"));
}

TEST_F(TlsTest, NewHandshakesReplaceTheSlowestPendingOnes) {
  const auto address = Listen(robot_, "robot");
  const HostPort place = *ParseAddress(address, 1);
  std::vector<os::Socket> slow;
  for (std::size_t i = 0; i < PendingTlsHandshakes::kMany; ++i) {
    auto one = os::ConnectTo(place.host, place.port, conformance::kTestTimeout);
    ASSERT_TRUE(one.ok());
    slow.push_back(*std::move(one));
  }
  Bytes hello = {std::byte(0x16), std::byte(3), std::byte(1), std::byte(0x40), std::byte(0)};
  hello.resize(hello.size() + 0x4000);  // the header claims these bytes
  std::size_t said = 0;
  const auto anna = As({.name = "anna"});

  EXPECT_TRUE(EventuallyTrue([&] {
    (void)Open(anna, address, "desk");
    const auto byte = std::span(hello).subspan(said++, 1);
    const auto is_ended = [&](const os::Socket& one) {
      Bytes buffer(64);
      return !os::SendSome(one, byte).has_value() || !os::ReceiveSome(one, buffer).has_value();
    };
    // Connections opened later may remain open longer.
    return std::count_if(slow.begin(), slow.end(), is_ended) > 0;
  }));
  EXPECT_LT(said, hello.size());
  EXPECT_TRUE(Open(anna, address, "desk").ok());
}

TEST_F(TlsTest, ACertificateWithoutItsKeyIsRefusedAtTheStart) {
  const auto file = Issue({.name = "anna"});
  fs::remove(file.key_file);

  const auto made =
      MakeIceMiddleware(Credentials{.certificate = file.certificate_file, .authority = folder});

  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(made.error().message, HasSubstr("has no private key (.key) in the same folder"));
}

}  // namespace
}  // namespace tendon::ice
