#pragma once

#include <tendon/ice/broker_connection.h>
#include <tendon/middleware/broadcast.h>
#include <tendon/process/worker.h>

#include <memory>
#include <string>

namespace tendon::ice {

/// The operation that carries a topic's messages; its parameter is one sequence of bytes.
inline constexpr const char* kTopicOperation = "message";

/// The publisher's end of a topic. The worker creates the topic, and checks every second that it
/// exists. Stop the worker before `connection` is destroyed.
std::unique_ptr<Broadcast::Topic> MakeTopic(const BrokerConnection& connection,
                                            std::shared_ptr<Worker> worker, std::string broker,
                                            std::string name);

}  // namespace tendon::ice
