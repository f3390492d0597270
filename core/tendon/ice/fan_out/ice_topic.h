#pragma once

#include <tendon/ice/fan_out/broker_door.h>
#include <tendon/middleware/fan_out/fan_out.h>
#include <tendon/process/worker.h>

#include <memory>
#include <string>

namespace tendon::ice {

/// The operation of a topic's message, with one sequence of bytes.
inline constexpr const char* kTopicOperation = "message";

/// The publisher's end of a topic. The worker creates the topic, and checks every second that it
/// exists. Stop the worker before `door` is destroyed.
std::unique_ptr<FanOut::Topic> MakeTopic(const BrokerDoor& door, std::shared_ptr<Worker> worker,
                                         std::string broker, std::string name);

}  // namespace tendon::ice
