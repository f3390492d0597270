#pragma once

#include <tendon/base/axis_ticks.h>
#include <tendon/payload/channel_value.h>
#include <tendon/payload/schema.h>

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace tendon {

/// An axis for values of one channel, whatever a payload can hold: how they stand above each other,
/// and what is written beside them. Bools and enums have a place for each value, with its name;
/// integers are exact and have whole steps; of floats the finite ones count.
class ChannelAxis {
 public:
  /// A place on the axis: 0 is its low end, 1 its high end.
  struct Label {
    double part = 0.0;
    std::string text;
  };

  /// As long as the values need. Has no labels.
  static ChannelAxis Tight(const Schema& schema, std::span<const ChannelValue> values);
  /// With round ends and about `most` labels, of which no two are alike.
  static ChannelAxis Fitted(const Schema& schema, std::span<const ChannelValue> values, int most);

  /// From the low end to the high end; empty where no value has a place.
  [[nodiscard]] const std::vector<Label>& labels() const { return labels_; }
  /// From 0 to 1, of one of the values; nothing for infinities and what is not a number.
  [[nodiscard]] std::optional<double> PartOf(const ChannelValue& value) const;

 private:
  using Names = std::map<std::int64_t, double>;  // the parts of values

  ChannelAxis(const Schema& schema, std::span<const ChannelValue> values,
              std::optional<int> most_labels);
  void UseNames(const Schema& schema, std::span<const ChannelValue> values);
  template <AxisNumber Number>
  void UseNumbers(std::span<const ChannelValue> values, std::optional<int> most_labels);

  std::variant<std::monostate, Names, AxisSpan<double>, AxisSpan<std::int64_t>,
               AxisSpan<std::uint64_t>>
      places_;
  std::vector<Label> labels_;
};

}  // namespace tendon
