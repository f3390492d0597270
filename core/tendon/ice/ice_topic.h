#pragma once

#include <tendon/ice/broker_connection.h>
#include <tendon/middleware/broadcast.h>
#include <tendon/process/worker.h>

#include <memory>
#include <string>

namespace tendon::ice {

/// The name of the operation that sends the messages of a topic. Its parameter is one sequence of
/// bytes.
inline constexpr const char* kTopicOperation = "message";

/// Returns a topic for its publisher. The worker creates the topic at the broker, and checks every
/// second that it still exists. The worker must be stopped before `connection` is destroyed.
std::unique_ptr<Broadcast::Topic> MakeTopic(const BrokerConnection& connection,
                                            std::shared_ptr<Worker> worker, std::string broker,
                                            std::string name);

}  // namespace tendon::ice
