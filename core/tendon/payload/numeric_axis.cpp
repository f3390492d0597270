#include <tendon/payload/numeric_axis.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace tendon {
namespace {

/// Converts a value to the number type of an axis. Empty if the value has no position on an axis.
template <AxisNumber Number>
std::optional<Number> NumberOf(const NumericValue& value) {
  if constexpr (std::is_integral_v<Number>) {
    return static_cast<Number>(value.integer());
  } else {
    const double real = value.real();
    return std::isfinite(real) ? std::optional(real) : std::nullopt;
  }
}

bool IsUnsigned(Schema::Kind kind) {
  return kind == Schema::Kind::kUint8 || kind == Schema::Kind::kUint16 ||
         kind == Schema::Kind::kUint32 || kind == Schema::Kind::kUint64;
}

}  // namespace

NumericAxis NumericAxis::Tight(const Schema& schema, std::span<const NumericValue> values) {
  return {schema, values, std::nullopt};
}

NumericAxis NumericAxis::Fitted(const Schema& schema, std::span<const NumericValue> values,
                                int most) {
  return {schema, values, most};
}

NumericAxis::NumericAxis(const Schema& schema, std::span<const NumericValue> values,
                         std::optional<int> most_labels) {
  const Schema::Kind kind = schema.kind();
  if (kind == Schema::Kind::kBool || kind == Schema::Kind::kEnum) {
    UseNames(schema, values);
    if (!most_labels) labels_.clear();
  } else if (!IsStepped(schema)) {
    UseNumbers<double>(values, most_labels);
  } else if (IsUnsigned(kind)) {
    UseNumbers<std::uint64_t>(values, most_labels);
  } else {
    UseNumbers<std::int64_t>(values, most_labels);
  }
}

/// Spaces the names equally, regardless of their numbers.
void NumericAxis::UseNames(const Schema& schema, std::span<const NumericValue> values) {
  constexpr double kMiddle = 0.5;
  Names names;
  if (schema.kind() == Schema::Kind::kBool) names = {{0, 0.0}, {1, 0.0}};
  for (const NumericValue& value : values) names.emplace(value.integer(), 0.0);
  const double last = names.empty() ? 0.0 : static_cast<double>(names.size() - 1);
  double index = 0.0;
  for (auto& [value, part] : names) {
    part = last == 0.0 ? kMiddle : index / last;
    index += 1.0;
    labels_.push_back({part, ToString(schema, NumericValue(value))});
  }
  places_ = std::move(names);
}

template <AxisNumber Number>
void NumericAxis::UseNumbers(std::span<const NumericValue> values, std::optional<int> most_labels) {
  auto low = std::numeric_limits<Number>::max();
  auto high = std::numeric_limits<Number>::lowest();
  for (const NumericValue& value : values) {
    const auto number = NumberOf<Number>(value);
    if (!number) continue;
    low = std::min(low, *number);
    high = std::max(high, *number);
  }
  if (low > high) return;
  if (!most_labels) {
    places_ = WidenedSpan(low, high);
    return;
  }
  const auto span = FittedSpan(low, high, *most_labels);
  for (const auto& tick : TicksOf(span, *most_labels)) {
    labels_.push_back({tendon::PartOf(span, tick.value), tick.label});
  }
  places_ = span;
}

std::optional<double> NumericAxis::PartOf(const NumericValue& value) const {
  if (const auto* names = std::get_if<Names>(&places_)) {
    const auto place = names->find(value.integer());
    return place == names->end() ? std::nullopt : std::optional(place->second);
  }
  const auto part = [&]<typename Number>(const AxisSpan<Number>& span) -> std::optional<double> {
    const auto number = NumberOf<Number>(value);
    return number ? std::optional(tendon::PartOf(span, *number)) : std::nullopt;
  };
  if (const auto* span = std::get_if<AxisSpan<double>>(&places_)) return part(*span);
  if (const auto* span = std::get_if<AxisSpan<std::int64_t>>(&places_)) return part(*span);
  if (const auto* span = std::get_if<AxisSpan<std::uint64_t>>(&places_)) return part(*span);
  return std::nullopt;
}

}  // namespace tendon
