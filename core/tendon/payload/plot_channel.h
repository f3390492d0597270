#pragma once

#include <tendon/payload/channel_value.h>
#include <tendon/payload/schema.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// One number inside a payload: what a plot can show as one curve.
struct PlotChannel {
  std::string path;  ///< ".position[0]", or empty where the payload itself is the number
  std::string unit;  ///< of the innermost field that has one; "s" for a duration without
  Schema schema;     ///< of the number: bool, integer, float, enum or duration
  /// Where it lies in every body, in bytes; nothing when a string or sequence comes before it.
  std::optional<std::size_t> offset;

  Schema root;                       ///< of the whole payload
  std::vector<std::uint32_t> route;  ///< from there on: indices of fields and elements
};

/// At most so many channels are listed; no body has more.
constexpr std::size_t kMaxChannels = 16384;

/// All numbers of a schema, in wire order, without the elements of sequences, whose number varies.
[[nodiscard]] std::vector<PlotChannel> Channels(const Schema& schema);

/// All numbers of one value, the elements of its sequences too. Empty if it does not decode.
[[nodiscard]] std::vector<PlotChannel> Channels(const Schema& schema,
                                                std::span<const std::byte> body);

/// The channel of a path as a person types it: ".cores[3].load". Elements of sequences may be
/// named, whether there are so many or not. The error says where the path leaves the schema.
[[nodiscard]] Result<PlotChannel> FindChannel(const Schema& schema, std::string_view path);

/// The number in one body. Nothing when the body is too short or has no such element. Costs a load
/// where the channel has an offset, else a walk over what comes before it; allocates nothing.
[[nodiscard]] std::optional<ChannelValue> ReadExactly(const PlotChannel& channel,
                                                      std::span<const std::byte> body);

/// The same as a double, which rounds integers beyond 2^53; a bool is 0 or 1, an enum its value, a
/// duration in seconds.
[[nodiscard]] std::optional<double> ReadChannel(const PlotChannel& channel,
                                                std::span<const std::byte> body);

}  // namespace tendon
