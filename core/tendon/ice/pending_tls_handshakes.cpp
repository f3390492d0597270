#include <tendon/ice/pending_tls_handshakes.h>

#include <tendon/base/log.h>
#include <tendon/base/os/socket.h>

#include <exception>
#include <string>

namespace tendon::ice {

int PendingTlsHandshakes::ContextIndex() {
  static const int index = SSL_CTX_get_ex_new_index(0, nullptr, nullptr, nullptr, nullptr);
  return index;
}

int PendingTlsHandshakes::LinkIndex() {
  static const int index = SSL_get_ex_new_index(0, nullptr, nullptr, nullptr, &OnFreed);
  return index;
}

PendingTlsHandshakes* PendingTlsHandshakes::Of(const SSL& link) {
  return static_cast<PendingTlsHandshakes*>(
      SSL_CTX_get_ex_data(SSL_get_SSL_CTX(&link), ContextIndex()));
}

void PendingTlsHandshakes::Watch(SSL_CTX& context) {
  LinkIndex();
  SSL_CTX_set_ex_data(&context, ContextIndex(), this);
  SSL_CTX_set_info_callback(&context, &OnInfo);
}

void PendingTlsHandshakes::OnInfo(const SSL* link, int what, int /*value*/) {
  PendingTlsHandshakes* const self = Of(*link);
  if (self == nullptr || SSL_is_server(link) == 0) return;
  try {  // called by C code
    if ((what & SSL_CB_HANDSHAKE_START) != 0) self->Begin(*link);
    if ((what & SSL_CB_HANDSHAKE_DONE) != 0) self->End(*link);
  } catch (const std::exception& failure) {
    Log(LogLevel::kError, "ice",
        std::string("the time of a TLS handshake is not limited: ") + failure.what());
  }
}

/// Removes the handshake. Called before the socket is closed, so no other connection can have the
/// same socket number yet.
void PendingTlsHandshakes::OnFreed(void* parent, void* /*own*/, CRYPTO_EX_DATA* /*data*/,
                                   int /*index*/, long /*argument*/, void* /*pointer*/) {
  const SSL& link = *static_cast<const SSL*>(parent);
  if (PendingTlsHandshakes* const self = Of(link)) self->End(link);
}

void PendingTlsHandshakes::Begin(const SSL& link) {
  const SteadyTime now = SteadyClock().Now();
  const std::scoped_lock lock(mutex_);
  if (unfinished_.size() >= kMany) {
    for (const auto& [other, one] : unfinished_) {
      if (now - one.since > kHandshakeTimeout) os::ShutDown(one.socket);
    }
  }
  unfinished_.emplace(&link, TlsHandshake{now, SSL_get_fd(&link)});
}

void PendingTlsHandshakes::End(const SSL& link) {
  const std::scoped_lock lock(mutex_);
  unfinished_.erase(&link);
}

}  // namespace tendon::ice
