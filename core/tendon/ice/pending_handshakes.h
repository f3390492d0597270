#pragma once

#include <Ice/Ice.h>
#include <IceUtil/Timer.h>
#include <tendon/ice/links.h>

#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

namespace tendon::ice {

/// Closes accepted connections that are not admitted after kAdmissionTime. The timeout of Ice does
/// not do this: it closes only a silent connection, not one that sends a byte from time to time. As
/// an observer of Ice, this object is notified of every new connection. It checks each connection
/// later, in the thread of Ice's timer. Thread-safe.
class PendingHandshakes final : public Ice::Instrumentation::CommunicatorObserver {
 public:
  /// Connections of an adapter are checked if its name begins with this prefix.
  static constexpr std::string_view kListener = "door";

  explicit PendingHandshakes(std::shared_ptr<Links> links) : links_(std::move(links)) {}

  /// Begins to check the connections of a communicator. The communicator must have been created
  /// with this observer.
  void Watch(const std::shared_ptr<Ice::Communicator>& communicator);

 private:
  // Short names for types of Ice.
  using Ended = Ice::Instrumentation::Observer;
  using OfConnection = Ice::Instrumentation::ConnectionObserver;
  using OfThread = Ice::Instrumentation::ThreadObserver;
  using Endpoint = std::shared_ptr<Ice::Endpoint>;

  std::shared_ptr<OfConnection> getConnectionObserver(
      const std::shared_ptr<Ice::ConnectionInfo>& info, const Endpoint& endpoint,
      Ice::Instrumentation::ConnectionState state,
      const std::shared_ptr<OfConnection>& before) override;

  std::shared_ptr<Ended> getConnectionEstablishmentObserver(const Endpoint& /*endpoint*/,
                                                            const std::string& /*to*/) override {
    return nullptr;
  }
  std::shared_ptr<Ended> getEndpointLookupObserver(const Endpoint& /*endpoint*/) override {
    return nullptr;
  }
  std::shared_ptr<OfThread> getThreadObserver(
      const std::string& /*pool*/, const std::string& /*name*/,
      Ice::Instrumentation::ThreadState /*state*/,
      const std::shared_ptr<OfThread>& /*before*/) override {
    return nullptr;
  }
  std::shared_ptr<Ice::Instrumentation::InvocationObserver> getInvocationObserver(
      const std::shared_ptr<Ice::ObjectPrx>& /*proxy*/, const std::string& /*operation*/,
      const Ice::Context& /*context*/) override {
    return nullptr;
  }
  std::shared_ptr<Ice::Instrumentation::DispatchObserver> getDispatchObserver(
      const Ice::Current& /*current*/, int /*size*/) override {
    return nullptr;
  }
  void setObserverUpdater(
      const std::shared_ptr<Ice::Instrumentation::ObserverUpdater>& /*updater*/) override {}

  const std::shared_ptr<Links> links_;
  std::mutex mutex_;
  IceUtil::TimerPtr timer_;  // null before Watch()
};

}  // namespace tendon::ice
