#pragma once

#include <tendon/payload/schema.h>
#include <tendon/recording/mcap_reader.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tendon::recording {

/// What the sequence of a message means.
enum class Sequence {
  kTick,   ///< of a row: one that is missing was lost
  kOther,  ///< messages of several programs may be out of order
};

/// The channels that are exported side by side: a table since one start of its source, an event, or
/// another topic.
struct ChannelGroup {
  std::string path;  ///< "robot/arm/state"
  Sequence sequence = Sequence::kOther;
  std::vector<const mcap::Channel*> channels;
};

/// The groups of the channels of `query`. Leaves out channels without a Tendon schema.
[[nodiscard]] std::vector<ChannelGroup> GroupsOf(const mcap::Reader& reader,
                                                 const mcap::Query& query);

/// One column of a table, an event, or another topic.
struct ChannelMember {
  std::string name;  ///< empty if the topic has only this one
  Schema schema;
};

/// Empty if the text of its schema is broken.
[[nodiscard]] std::optional<ChannelMember> MemberOf(const mcap::Channel& channel);

/// The time of a message on the steady clock of its source is its publish time minus this, ns.
[[nodiscard]] std::int64_t ClockOf(const mcap::Channel& channel);

/// The error for a recording that has nothing to export.
[[nodiscard]] Error NothingToExport(const mcap::Reader& reader);

}  // namespace tendon::recording
