#pragma once

#include <Ice/Ice.h>
#include <tendon/ice/fan_out/broker_door.h>
#include <tendon/middleware/fan_out/fan_out.h>
#include <tendon/process/worker.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace tendon::ice {

/// Fan-out by IceStorm. Its own interfaces are called by the code that Ice generated for them, for
/// the broker is one of our programs: see BrokerDoor. What comes from a topic is anybody's, and is
/// read as frames are.
class IceFanOut final : public FanOut {
 public:
  IceFanOut(std::shared_ptr<Ice::Communicator> communicator, bool is_certified);
  ~IceFanOut() override;

  std::unique_ptr<Topic> Speak(const std::string& broker, const std::string& name) override;
  Result<std::unique_ptr<Reception>> Listen(const std::string& broker, const std::string& name,
                                            Hear hear, std::chrono::milliseconds timeout) override;

 private:
  /// Where the broker reaches listeners: at the end of our connection to it, any port.
  std::shared_ptr<Ice::ObjectAdapter> AdapterAt(const std::string& host);

  const std::shared_ptr<Ice::Communicator> communicator_;
  const BrokerDoor door_;
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<Ice::ObjectAdapter>> adapters_;  // by host
  std::shared_ptr<Worker> worker_;                                       // of who speaks
};

}  // namespace tendon::ice
