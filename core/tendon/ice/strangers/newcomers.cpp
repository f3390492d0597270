#include <tendon/base/os/socket.h>
#include <tendon/ice/strangers/newcomers.h>

#include <cstdint>

namespace tendon::ice {
namespace {

/// What is done when the patience with one of them has come to its end.
class Look final : public IceUtil::TimerTask {
 public:
  Look(std::shared_ptr<Links> links, std::shared_ptr<Ice::IPConnectionInfo> where)
      : links_(std::move(links)), where_(std::move(where)) {}

  void runTimerTask() override {
    if (const auto link = links_->Find(EndsOf(*where_))) return link->CheckAdmission();
    os::ShutDown(static_cast<std::uint16_t>(where_->localPort),
                 static_cast<std::uint16_t>(where_->remotePort));
  }

 private:
  const std::shared_ptr<Links> links_;
  const std::shared_ptr<Ice::IPConnectionInfo> where_;
};

}  // namespace

void Newcomers::Watch(const std::shared_ptr<Ice::Communicator>& communicator) {
  const std::scoped_lock lock(mutex_);
  timer_ = IceInternal::getInstanceTimer(communicator);
}

std::shared_ptr<Newcomers::OfConnection> Newcomers::getConnectionObserver(
    const std::shared_ptr<Ice::ConnectionInfo>& info, const Endpoint& /*endpoint*/,
    Ice::Instrumentation::ConnectionState state, const std::shared_ptr<OfConnection>& /*before*/) {
  const bool is_new = state == Ice::Instrumentation::ConnectionState::ConnectionStateActive;
  if (!is_new || !info->incoming || !info->adapterName.starts_with(kDoor)) return nullptr;
  const auto where = AddressIn(info);
  const std::scoped_lock lock(mutex_);
  if (where && timer_) {
    timer_->schedule(std::make_shared<Look>(links_, where),
                     IceUtil::Time::seconds(kPatience.count()));
  }
  return nullptr;
}

}  // namespace tendon::ice
