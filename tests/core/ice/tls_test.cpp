#include <gmock/gmock.h>
#include <tendon/ice/ice_middleware.h>
#include <tendon/middleware/channel.h>
#include <tendon/security/authority_folder.h>
#include <tendon/security/openssl/making.h>
#include <tendon/security/openssl/pem.h>

#include <algorithm>
#include <mutex>
#include <random>
#include <string>
#include <vector>

#include "conformance/resources.h"
#include "core/ice/attacks.h"
#include "core/security/authority.h"
#include "support/log/log_record.h"
#include "support/wait.h"

namespace tendon::ice {
namespace {

namespace fs = std::filesystem;
using tendon_test::LogRecord;
using testing::HasSubstr;

constexpr std::chrono::seconds kPatience(20);
constexpr auto kProcess = Holder::kProcess;
#ifdef __SANITIZE_ADDRESS__
constexpr std::size_t kMostMemory = std::size_t{512} << 20U;  // it keeps 256 MiB of what was freed
#else
constexpr std::size_t kMostMemory = std::size_t{16} << 20U;
#endif

/// Remembers who came.
class Guestbook final : public ChannelHandler {
 public:
  void OnOpen(const std::shared_ptr<Channel>& /*channel*/, const Hello& peer) override {
    const std::scoped_lock lock(mutex_);
    guests_.push_back(peer);
  }
  [[nodiscard]] std::vector<Hello> guests() const {
    const std::scoped_lock lock(mutex_);
    return guests_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<Hello> guests_;
};

struct Deaf final : LinkHandler {
  void OnFrame(std::span<const std::byte> /*frame*/) override {}
  void OnClosed(const Error& /*reason*/) override {}
};

class TlsTest : public AuthorityTest {
 protected:
  using Shared = std::shared_ptr<Middleware>;

  /// Of whoever has such a certificate.
  [[nodiscard]] Shared As(const Request& request) const {
    return Showing(Issue(request).certificate_file);
  }
  [[nodiscard]] Shared Showing(const fs::path& certificate) const {
    return Showing(certificate, folder);
  }
  [[nodiscard]] static Shared Showing(const fs::path& certificate, const fs::path& authority) {
    auto made = MakeIceMiddleware(Credentials{.certificate = certificate, .authority = authority});
    EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().message);
    return made.ok() ? *std::move(made) : nullptr;
  }
  /// The file of a certificate of the process `old`, made long ago.
  [[nodiscard]] fs::path Expiring(std::chrono::seconds from_now) const {
    const Request request{.name = "old", .role = Role::kOperator, .holder = kProcess};
    const auto issued = Issue(request);
    const auto key = ReadPrivateKey(issued.key_file);
    const auto ca_key = ReadPrivateKey(folder / "ca.key");
    const auto ca = ReadAuthority({folder});
    home.Write("out/old.crt", openssl::PemOf(*openssl::MakeCertificate(
                                  request, **key, Now() + from_now, {**ca, **ca_key})));
    return issued.certificate_file;
  }
  /// Does not know of what is revoked from now on.
  [[nodiscard]] fs::path CopyOfPublicFiles() const {
    const fs::path copy = home.path() / "copy";
    fs::create_directory(copy);
    for (const char* file : {"ca.crt", "crl.pem"}) fs::copy_file(folder / file, copy / file);
    return copy;
  }

  /// Calls itself `name`, until the test ends.
  std::string Listen(const Shared& middleware, const std::string& name) {
    auto listener = middleware->Listen(
        "127.0.0.1:0", Channel::Acceptor(HelloOf(name), [this] { return guestbook_; }));
    EXPECT_TRUE(listener.ok());
    listeners_.push_back(*std::move(listener));
    return listeners_.back()->address();
  }
  static Result<std::shared_ptr<Channel>> Open(const Shared& middleware, const std::string& address,
                                               const std::string& name,
                                               const std::string& wanted = "") {
    Hello hello = HelloOf(name);
    hello.wanted = wanted;
    return Channel::Open(*middleware, address, hello, std::make_shared<ChannelHandler>(),
                         kPatience);
  }
  /// Opens, which must fail.
  static Error Refusal(const Shared& middleware, const std::string& address,
                       const std::string& wanted = "") {
    const auto channel = Open(middleware, address, "desk", wanted);
    EXPECT_FALSE(channel.ok());
    return channel.ok() ? Error() : channel.error();
  }
  /// As whom a program that calls itself `name` is known where it comes to.
  Hello Guest(const Shared& middleware, const std::string& name) {
    const std::size_t before = guestbook_->guests().size();
    const auto channel = Open(middleware, Listen(robot_, "robot"), name);
    EXPECT_TRUE(channel.ok()) << (channel.ok() ? "" : channel.error().message);
    EXPECT_TRUE(EventuallyTrue([&] { return guestbook_->guests().size() > before; }));
    listeners_.clear();
    return guestbook_->guests().back();
  }
  /// What whoever decides writes down.
  bool EventuallyAudited(const std::string& text) const {
    return EventuallyTrue([&] {
      const auto texts = audit_.texts();
      return std::any_of(texts.begin(), texts.end(),
                         [&](const std::string& line) { return line.find(text) != line.npos; });
    });
  }

  const std::shared_ptr<Guestbook> guestbook_ = std::make_shared<Guestbook>();
  const Shared robot_ = As({.name = "robot", .role = Role::kOperator, .holder = kProcess});

 private:
  static Hello HelloOf(const std::string& name) { return {.instance = 1, .name = name}; }

  const LogRecord audit_{"audit"};
  std::vector<std::unique_ptr<Listener>> listeners_;
};

TEST_F(TlsTest, TheOpenerKnowsWhoTheAcceptorIs) {
  const auto anna = As({.name = "anna"});

  const auto channel = Open(anna, Listen(robot_, "robot"), "gcm ls", "robot");

  ASSERT_TRUE(channel.ok()) << channel.error().message;
  EXPECT_EQ((*channel)->peer().name, "robot");
  EXPECT_EQ((*channel)->peer().role, Role::kOperator);
}

TEST_F(TlsTest, TheAcceptorKnowsNameAndRoleByTheCertificate) {
  const auto desk = As({.name = "desk", .role = Role::kOperator, .holder = kProcess});
  const auto anna = As({.name = "anna", .role = Role::kViewer});

  EXPECT_EQ(Guest(desk, "desk").name, "desk");
  EXPECT_EQ(Guest(desk, "desk").role, Role::kOperator);
  EXPECT_EQ(Guest(desk, "gcm").name, "desk (gcm)");
  EXPECT_EQ(Guest(anna, "gcm ls").name, "anna (gcm ls)");
  EXPECT_EQ(Guest(anna, "gcm ls").role, Role::kViewer);
  EXPECT_EQ(Guest(anna, "anna").name, "anna (anna)") << "a person is no process";
}

TEST_F(TlsTest, WhoCallsItselfAnotherThanItsCertificateDoesIsNotTrusted) {
  const auto arm = As({.name = "arm", .role = Role::kOperator, .holder = kProcess});

  const auto refusal = Refusal(robot_, Listen(arm, "gcm"), "gcm");

  EXPECT_EQ(refusal.code, ErrorCode::kDenied);
  EXPECT_THAT(refusal.message,
              HasSubstr("calls itself 'gcm', but shows the certificate of the process 'arm'"));
}

TEST_F(TlsTest, AnotherThanTheOneWantedIsNotTalkedTo) {
  const auto refusal = Refusal(As({.name = "anna"}), Listen(robot_, "robot"), "gcm");

  EXPECT_EQ(refusal.code, ErrorCode::kUnreachable);
  EXPECT_THAT(refusal.message, HasSubstr("is 'robot', not 'gcm'"));
}

TEST_F(TlsTest, WhoWasRevokedHearsItAndNobodyLetsItIn) {
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

TEST_F(TlsTest, NoLinkIsOpenedToOneWhoWasRevoked) {
  const auto arm = As({.name = "arm", .role = Role::kOperator, .holder = kProcess});
  const auto address = Listen(arm, "arm");
  ASSERT_TRUE(Open(robot_, address, "robot").ok());
  ASSERT_TRUE(authority->Revoke("arm").ok());

  const auto refusal = Refusal(robot_, address);

  EXPECT_EQ(refusal.code, ErrorCode::kDenied);
  EXPECT_THAT(refusal.message, HasSubstr("is not trusted: the certificate of 'arm' was revoked"));
}

TEST_F(TlsTest, AnotherCaIsNotBelievedByEitherEnd) {
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

TEST_F(TlsTest, APersonIsNoAcceptor) {
  const auto anna = As({.name = "anna", .role = Role::kOperator});

  const auto refusal = Refusal(robot_, Listen(anna, "anna"));

  EXPECT_EQ(refusal.code, ErrorCode::kDenied);
  EXPECT_THAT(refusal.message, HasSubstr("it shows the certificate of a person"));
}

TEST_F(TlsTest, AnExpiredCertificateIsNotEvenShown) {
  const auto file = Expiring(std::chrono::minutes(-1));

  const auto own = MakeIceMiddleware(Credentials{.certificate = file, .authority = folder});

  ASSERT_FALSE(own.ok());
  EXPECT_THAT(own.error().message, HasSubstr("expired on "));
}

TEST_F(TlsTest, WhoseCertificateHasExpiredMeanwhileIsNotTrusted) {
  const auto old = Showing(Expiring(std::chrono::seconds(4)));
  const auto address = Listen(old, "old");
  std::string why;

  EXPECT_TRUE(EventuallyTrue([&] {
    const auto channel = Open(robot_, address, "robot");
    if (!channel) why = channel.error().message;
    return !channel;
  }));

  EXPECT_THAT(why, HasSubstr("expired"));
}

TEST_F(TlsTest, AViewersCertificateIsNotThatOfOneWhoGivesOrders) {
  const auto gcm = As({.name = "gcm", .role = Role::kViewer, .holder = kProcess});

  const auto refusal = Refusal(robot_, Listen(gcm, "gcm"), "gcm");

  EXPECT_EQ(refusal.code, ErrorCode::kDenied);
  EXPECT_THAT(refusal.message, HasSubstr("shows a viewer's certificate"));
}

TEST_F(TlsTest, WhoeverIsRefusedIsNamedWhateverTheLogLevel) {
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

TEST_F(TlsTest, WithoutItsCaFilesAProgramTrustsNobodyUntilTheyAreBack) {
  const auto address = Listen(robot_, "robot");
  const auto anna = Showing(Issue({.name = "anna"}).certificate_file, CopyOfPublicFiles());
  fs::rename(folder / "crl.pem", home.path() / "kept");

  EXPECT_FALSE(Open(anna, address, "gcm").ok());
  fs::rename(home.path() / "kept", folder / "crl.pem");
  EXPECT_TRUE(Open(anna, address, "gcm").ok());
}

TEST_F(TlsTest, WithoutACertificateNobodyIsLetIn) {
  const std::shared_ptr<Middleware> plain = MakeIceMiddleware(Exposure::kLoopbackOnly);
  const auto address = Listen(robot_, "robot");

  const auto channel =
      plain->Open(address, std::make_shared<Deaf>(), std::chrono::milliseconds(500));

  ASSERT_FALSE(channel.ok());
  EXPECT_EQ(channel.error().code, ErrorCode::kTimeout);
  EXPECT_THAT(channel.error().message, HasSubstr("or wants a --certificate"));
}

TEST_F(TlsTest, WhatStrangersSayIsNotEvenRead) {
  const auto address = Listen(robot_, "robot");
  const auto place = ParseAddress(address, 1);
  const auto anna = As({.name = "anna"});
  const auto standing = Open(anna, address, "gcm");
  ASSERT_TRUE(standing.ok());
  const std::size_t memory = conformance::MemoryInUse();
  std::vector<Bytes> messages;
  for (const auto& [name, attack] : Attacks()) messages.push_back(attack);
  std::mt19937 random(4711);
  for (int i = 0; i < 2000; ++i) {
    messages.push_back(WithSequence(4).Finished());
    messages.back()[random() % messages.back().size()] = static_cast<std::byte>(random());
  }

  for (const Bytes& message : messages) {
    const auto socket = os::ConnectTo(place->host, place->port, kPatience);
    ASSERT_TRUE(socket.ok()) << socket.error().message;
    SendAll(*socket, message);
  }

  EXPECT_TRUE((*standing)->is_open());
  EXPECT_TRUE(Open(anna, address, "gcm").ok());
  EXPECT_TRUE(EventuallyTrue([this] { return guestbook_->guests().size() == 2; }));
  EXPECT_LT(conformance::MemoryInUse(), memory + kMostMemory);
}

TEST_F(TlsTest, WhoSpeaksNoTlsIsNotSpokenTo) {
  const std::shared_ptr<Middleware> plain = MakeIceMiddleware(Exposure::kLoopbackOnly);

  const auto refusal = Refusal(As({.name = "anna"}), Listen(plain, "robot"));

  EXPECT_EQ(refusal.code, ErrorCode::kUnreachable);
  EXPECT_THAT(refusal.message, HasSubstr("or speaks no TLS"));
}

TEST_F(TlsTest, ACertificateWithoutItsKeyIsRefusedAtTheStart) {
  const auto file = Issue({.name = "anna"});
  fs::remove(file.key_file);

  const auto made =
      MakeIceMiddleware(Credentials{.certificate = file.certificate_file, .authority = folder});

  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(made.error().message, HasSubstr("has no private key beside it"));
}

}  // namespace
}  // namespace tendon::ice
