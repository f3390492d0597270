#include <tendon/ice/pending_handshakes.h>

#include <tendon/base/os/socket.h>

#include <utility>

namespace tendon::ice {
namespace {

/// Closes one connection if it is not admitted. Runs kAdmissionTime after the connection was
/// accepted.
class AdmissionCheck final : public IceUtil::TimerTask {
 public:
  AdmissionCheck(std::shared_ptr<Links> links, SocketAddresses addresses)
      : links_(std::move(links)), addresses_(std::move(addresses)) {}

  void runTimerTask() override {
    if (const auto link = links_->Find(addresses_)) return link->CheckAdmission();
    os::ShutDown(addresses_.local, addresses_.peer);
  }

 private:
  const std::shared_ptr<Links> links_;
  const SocketAddresses addresses_;
};

/// Observes one connection as long as it is open.
class PendingHandshake final : public Ice::Instrumentation::ConnectionObserver {
 public:
  PendingHandshake(IceUtil::TimerPtr timer, std::shared_ptr<AdmissionCheck> check)
      : timer_(std::move(timer)), check_(std::move(check)) {}

  void attach() override {
    try {
      timer_->schedule(check_, IceUtil::Time::seconds(kAdmissionTime.count()));
    } catch (const IceUtil::Exception&) {
      // The communicator is being destroyed with all its connections.
    }
  }
  void detach() override { timer_->cancel(check_); }
  void failed(const std::string& /*exception*/) override {}
  void sentBytes(int /*count*/) override {}
  void receivedBytes(int /*count*/) override {}

 private:
  const IceUtil::TimerPtr timer_;
  const std::shared_ptr<AdmissionCheck> check_;
};

}  // namespace

void PendingHandshakes::Watch(const std::shared_ptr<Ice::Communicator>& communicator) {
  const std::scoped_lock lock(mutex_);
  timer_ = IceInternal::getInstanceTimer(communicator);
}

std::shared_ptr<PendingHandshakes::OfConnection> PendingHandshakes::getConnectionObserver(
    const std::shared_ptr<Ice::ConnectionInfo>& info, const Endpoint& /*endpoint*/,
    Ice::Instrumentation::ConnectionState state, const std::shared_ptr<OfConnection>& /*before*/) {
  const bool is_new = state == Ice::Instrumentation::ConnectionState::ConnectionStateActive;
  if (!is_new || !info->incoming || !info->adapterName.starts_with(kListener)) return nullptr;
  const auto where = AddressIn(info);
  const std::scoped_lock lock(mutex_);
  if (!where || !timer_) return nullptr;
  return std::make_shared<PendingHandshake>(
      timer_, std::make_shared<AdmissionCheck>(links_, AddressesOf(*where)));
}

}  // namespace tendon::ice
