#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <openssl/err.h>
#include <openssl/ssl.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <tendon/base/os/socket.h>
#include <tendon/middleware/middleware.h>
#include <tendon/security/openssl_handles.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "conformance/recorder.h"

namespace tendon::ice {

/// A TLS client that can send arbitrary bytes inside TLS.
class TlsClient {
 public:
  /// One end of a connection. Waits for data, but not forever.
  class Connection {
   public:
    Connection(SSL_CTX& context, const HostPort& place) : link_(SSL_new(&context)) {
      auto socket = os::ConnectTo(place.host, place.port, conformance::kTestTimeout);
      EXPECT_TRUE(socket.ok()) << (socket.ok() ? "" : socket.error().message);
      if (socket.ok()) socket_ = *std::move(socket);
      const timeval timeout{.tv_sec = conformance::kTestTimeout.count(), .tv_usec = 0};
      setsockopt(socket_.descriptor(), SOL_SOCKET, SO_RCVTIMEO, &timeout, sizeof(timeout));
      fcntl(socket_.descriptor(), F_SETFL, fcntl(socket_.descriptor(), F_GETFL) & ~O_NONBLOCK);
      SSL_set_fd(link_.get(), socket_.descriptor());
      is_up_ = SSL_connect(link_.get()) == 1;
    }

    /// Returns true if the handshake has succeeded at this end. With TLS 1.3, a client learns only
    /// later that the server has refused it.
    [[nodiscard]] bool is_up() const { return is_up_; }

    bool Send(const Bytes& bytes) {
      ERR_clear_error();
      return is_up_ && SSL_write(link_.get(), bytes.data(), static_cast<int>(bytes.size())) > 0;
    }
    /// Returns nothing if the connection has ended.
    Bytes Receive() {
      ERR_clear_error();
      errno = 0;
      Bytes buffer(4096);
      const int size =
          is_up_ ? SSL_read(link_.get(), buffer.data(), static_cast<int>(buffer.size())) : 0;
      EXPECT_FALSE(size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) << "no reply, no end";
      buffer.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
      return buffer;
    }

   private:
    os::Socket socket_;
    openssl::Handle<SSL, SSL_free> link_;
    bool is_up_ = false;
  };

  /// Creates a client; without a file, the client has no certificate.
  explicit TlsClient(const std::optional<std::filesystem::path>& certificate) {
    std::signal(SIGPIPE, SIG_IGN);
    if (!certificate) return;
    auto key = *certificate;
    key.replace_extension(".key");
    const bool has_both =
        SSL_CTX_use_certificate_file(context_.get(), certificate->c_str(), SSL_FILETYPE_PEM) == 1 &&
        SSL_CTX_use_PrivateKey_file(context_.get(), key.c_str(), SSL_FILETYPE_PEM) == 1;
    EXPECT_TRUE(has_both) << *certificate;
  }

  [[nodiscard]] Connection ConnectTo(const HostPort& place) const { return {*context_, place}; }

 private:
  const openssl::Handle<SSL_CTX, SSL_CTX_free> context_{SSL_CTX_new(TLS_client_method())};
};

}  // namespace tendon::ice
