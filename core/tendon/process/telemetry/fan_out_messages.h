#pragma once

#include <tendon/process/messages.h>

#include <string>

/// How viewers come to hear rows by a broker, all of them what the process has sent once.
namespace tendon::message {

// From a viewer to a process: as kSubscribe, but the rows come by a topic. What it says of the
// handle holds: kUnsubscribe from the viewer ends it, kRowsEnded from the process. A message of the
// topic is the body of kRows; `rows_before` counts what was sent to the topic ever, and a message
// comes at least each second, if without rows, so that whoever missed something learns of it.
inline constexpr auto kJoinTopic =
    static_cast<MessageType>(0x20a);  // request: Subscribe -> TopicJoined
// From a viewer or a process to a GCM.
inline constexpr auto kFanOut = static_cast<MessageType>(0x31c);  // request: None -> FanOutPlace

/// The answer to kJoinTopic.
struct TopicJoined {
  Subscribed subscribed;  ///< `first_tick` means nothing: it is that of the first row to come
  std::string topic;
};

/// Where the broker is.
struct FanOutPlace {
  std::string address;  ///< empty where there is none
};

}  // namespace tendon::message

template <>
inline constexpr auto tendon::kPayload<tendon::message::TopicJoined> = tendon::Describe(
    "tendon.TopicJoined", tendon::Field{"subscribed", &tendon::message::TopicJoined::subscribed},
    tendon::Field{"topic", &tendon::message::TopicJoined::topic});

template <>
inline constexpr auto tendon::kPayload<tendon::message::FanOutPlace> = tendon::Describe(
    "tendon.FanOutPlace", tendon::Field{"address", &tendon::message::FanOutPlace::address});
