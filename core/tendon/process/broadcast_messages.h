#pragma once

#include <tendon/process/viewer_messages.h>

#include <string>

/// Messages for rows through a broker: the process sends each row once for all viewers.
namespace tendon::message {

// From a viewer to a process: like kSubscribe, but the rows are published in a topic. The handle is
// used for kUnsubscribe and kRowsEnded as usual. Each message of the topic is the body of a kRows,
// and its `rows_before` counts all rows ever sent to the topic. At least one message is published
// each second, possibly without rows, so that receivers notice losses.
inline constexpr auto kJoinTopic =
    static_cast<MessageType>(0x20a);  // request: Subscribe -> JoinTopicReply
// From a viewer or a process to a GCM.
inline constexpr auto kGetBroker =
    static_cast<MessageType>(0x31c);  // request: None -> BrokerAddress

/// The reply to kJoinTopic.
struct JoinTopicReply {
  SubscribeReply subscribed;  ///< without `first_tick`: the first row begins
  std::string topic;
};

/// The address of the broker.
struct BrokerAddress {
  std::string address;  ///< empty if there is no broker
};

}  // namespace tendon::message

template <>
inline constexpr auto tendon::kPayload<tendon::message::JoinTopicReply> =
    tendon::Describe("tendon.JoinTopicReply",
                     tendon::Field{"subscribed", &tendon::message::JoinTopicReply::subscribed},
                     tendon::Field{"topic", &tendon::message::JoinTopicReply::topic});

template <>
inline constexpr auto tendon::kPayload<tendon::message::BrokerAddress> = tendon::Describe(
    "tendon.BrokerAddress", tendon::Field{"address", &tendon::message::BrokerAddress::address});
