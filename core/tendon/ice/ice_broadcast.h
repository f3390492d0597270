#pragma once

#include <Ice/Ice.h>
#include <tendon/ice/broker_connection.h>
#include <tendon/middleware/broadcast.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace tendon::ice {

/// Multicast through IceStorm. The calls to the broker use generated code of Ice, because the
/// broker is trusted (see BrokerConnection). The messages of a topic are untrusted, so
/// BoundedReader reads them.
class IceBroadcast final : public Broadcast {
 public:
  IceBroadcast(std::shared_ptr<Ice::Communicator> communicator, bool is_certified);
  ~IceBroadcast() override;

  std::unique_ptr<Topic> OpenTopic(const std::string& broker, const std::string& name) override;
  Result<std::unique_ptr<Subscription>> Subscribe(const std::string& broker,
                                                  const std::string& name, MessageHandler handler,
                                                  std::chrono::milliseconds timeout) override;

 private:
  /// Returns the adapter that receives messages from the broker. The adapter has a free port, and
  /// the address of this machine on the route to the broker.
  std::shared_ptr<Ice::ObjectAdapter> AdapterAt(const std::string& host);

  const std::shared_ptr<Ice::Communicator> communicator_;
  const BrokerConnection connection_;
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<Ice::ObjectAdapter>> adapters_;  // by host
  std::shared_ptr<Worker> worker_;  // maintains the topics of publishers
};

}  // namespace tendon::ice
