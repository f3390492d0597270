#include <tendon/base/os/socket.h>
#include <tendon/ice/handshakes.h>

namespace tendon::ice {

int Handshakes::ContextIndex() {
  static const int index = SSL_CTX_get_ex_new_index(0, nullptr, nullptr, nullptr, nullptr);
  return index;
}

int Handshakes::LinkIndex() {
  static const int index = SSL_get_ex_new_index(0, nullptr, nullptr, nullptr, &OnFreed);
  return index;
}

Handshakes* Handshakes::Of(const SSL& link) {
  return static_cast<Handshakes*>(SSL_CTX_get_ex_data(SSL_get_SSL_CTX(&link), ContextIndex()));
}

void Handshakes::Watch(SSL_CTX& context) {
  LinkIndex();
  SSL_CTX_set_ex_data(&context, ContextIndex(), this);
  SSL_CTX_set_info_callback(&context, &OnInfo);
}

void Handshakes::OnInfo(const SSL* link, int what, int /*value*/) {
  Handshakes* const self = Of(*link);
  if (self == nullptr || SSL_is_server(link) == 0) return;
  if ((what & SSL_CB_HANDSHAKE_START) != 0) self->Begin(*link);
  if ((what & SSL_CB_HANDSHAKE_DONE) != 0) self->End(*link);
}

/// Before its socket is closed, whose number another may have then.
void Handshakes::OnFreed(void* parent, void* /*own*/, CRYPTO_EX_DATA* /*data*/, int /*index*/,
                         long /*argument*/, void* /*pointer*/) {
  const SSL& link = *static_cast<const SSL*>(parent);
  if (Handshakes* const self = Of(link)) self->End(link);
}

void Handshakes::Begin(const SSL& link) {
  const SteadyTime now = SteadyClock().Now();
  const std::scoped_lock lock(mutex_);
  for (const auto& [other, since] : begun_) {
    if (now - since > kPatience) os::ShutDown(SSL_get_fd(other));
  }
  begun_.emplace(&link, now);
}

void Handshakes::End(const SSL& link) {
  const std::scoped_lock lock(mutex_);
  begun_.erase(&link);
}

}  // namespace tendon::ice
