#pragma once

#include <tendon/ice/fan_out/broker_door.h>
#include <tendon/middleware/fan_out/fan_out.h>
#include <tendon/process/worker.h>

#include <memory>
#include <string>

namespace tendon::ice {

/// What a message of a topic is invoked as, with one sequence of bytes.
inline constexpr const char* kTopicOperation = "message";

/// The speaker's end of a topic; the worker makes it, and looks each second whether it is there
/// still. Stop the worker before the door goes.
std::unique_ptr<FanOut::Topic> MakeTopic(const BrokerDoor& door, std::shared_ptr<Worker> worker,
                                         std::string broker, std::string name);

}  // namespace tendon::ice
