#pragma once

#include <gmock/gmock.h>
#include <tendon/ice/ice_middleware.h>
#include <tendon/middleware/channel.h>
#include <tendon/security/authority_folder.h>
#include <tendon/security/certificate_builder.h>
#include <tendon/security/pem.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "conformance/recorder.h"
#include "core/security/authority.h"
#include "support/log/log_record.h"
#include "support/record.h"
#include "support/wait.h"

namespace tendon::ice {

namespace fs = std::filesystem;

inline constexpr auto kProcess = Holder::kProcess;

/// Records the Hello of each peer.
class Guestbook final : public ChannelHandler {
 public:
  void OnOpen(const std::shared_ptr<Channel>& /*channel*/, const Hello& peer) override {
    guests_.Add(peer);
  }
  [[nodiscard]] std::vector<Hello> guests() const { return guests_.values(); }

 private:
  test::Record<Hello> guests_;
};

struct Deaf final : LinkHandler {
  void OnFrame(std::span<const std::byte> /*frame*/) override {}
  void OnClosed(const Error& /*reason*/) override {}
};

/// Programs under TLS in this process. Their certificates are from one CA.
class TlsTest : public AuthorityTest {
 protected:
  using Shared = std::shared_ptr<Middleware>;

  /// Returns a middleware with a certificate for this request.
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
  /// Returns the file of a certificate of the process `old`, which expires `from_now` from now.
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
  /// Returns a copy of the CA's public files. Later lists of revoked certificates are not copied.
  [[nodiscard]] fs::path CopyOfPublicFiles() const {
    const fs::path copy = home.path() / "copy";
    fs::create_directory(copy);
    for (const char* file : {"ca.crt", "crl.pem"}) fs::copy_file(folder / file, copy / file);
    return copy;
  }

  /// Listens under the name `name` until the test ends.
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
                         conformance::kTestTimeout);
  }
  /// Opens a channel, which must fail, and returns the error.
  static Error Refusal(const Shared& middleware, const std::string& address,
                       const std::string& wanted = "") {
    const auto channel = Open(middleware, address, "desk", wanted);
    EXPECT_FALSE(channel.ok());
    return channel.ok() ? Error() : channel.error();
  }
  /// Returns the Hello that a peer records for a program that calls itself `name`.
  Hello Guest(const Shared& middleware, const std::string& name) {
    const std::size_t before = guestbook_->guests().size();
    const auto channel = Open(middleware, Listen(robot_, "robot"), name);
    EXPECT_TRUE(channel.ok()) << (channel.ok() ? "" : channel.error().message);
    EXPECT_TRUE(EventuallyTrue([&] { return guestbook_->guests().size() > before; }));
    listeners_.clear();
    return guestbook_->guests().back();
  }
  /// Waits until the audit log contains `text`.
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

  const tendon_test::LogRecord audit_{"audit"};
  std::vector<std::unique_ptr<Listener>> listeners_;
};

}  // namespace tendon::ice
