#pragma once

#include <tendon/base/axis_ticks.h>
#include <tendon/payload/numeric_value.h>
#include <tendon/payload/schema.h>

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace tendon {

/// An axis for the values of one field, which may have any type. The axis computes the positions of
/// the values and of the labels. Bools and enums have one position for each value, labelled with
/// the name of the value. Integers are exact, and labels have integer steps. Floats that are not
/// finite are ignored.
class NumericAxis {
 public:
  /// A label. `part` is its position on the axis: 0 is the low end, 1 the high end.
  struct Label {
    double part = 0.0;
    std::string text;
  };

  /// Makes an axis that is just long enough for the values and has no labels.
  static NumericAxis Tight(const Schema& schema, std::span<const NumericValue> values);
  /// Makes an axis that begins and ends with round numbers. It has about `most` labels, all of them
  /// different.
  static NumericAxis Fitted(const Schema& schema, std::span<const NumericValue> values, int most);

  /// Sorted from the low end to the high end; empty if no value has a position.
  [[nodiscard]] const std::vector<Label>& labels() const { return labels_; }
  /// The position of a value, from 0 to 1; empty for infinities and not-a-number.
  [[nodiscard]] std::optional<double> PartOf(const NumericValue& value) const;

 private:
  using Names = std::map<std::int64_t, double>;  // the positions of values

  NumericAxis(const Schema& schema, std::span<const NumericValue> values,
              std::optional<int> most_labels);
  void UseNames(const Schema& schema, std::span<const NumericValue> values);
  template <AxisNumber Number>
  void UseNumbers(std::span<const NumericValue> values, std::optional<int> most_labels);

  std::variant<std::monostate, Names, AxisSpan<double>, AxisSpan<std::int64_t>,
               AxisSpan<std::uint64_t>>
      places_;
  std::vector<Label> labels_;
};

}  // namespace tendon
