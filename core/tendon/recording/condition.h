#pragma once

#include <tendon/base/path.h>
#include <tendon/base/result.h>
#include <tendon/payload/numeric_field.h>
#include <tendon/payload/schema.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tendon::recording {

/// What begins or ends a recording, as a person types it: an event,
/// "robot/arm/Control.GoalReached", or a value of a state table,
/// "robot/arm/state.Joints.position[2] > 1.2 rad".
struct Condition {
  enum class Relation { kLess, kLessOrEqual, kGreater, kGreaterOrEqual, kEqual, kNotEqual };
  /// The right side is a number, true, false, or the name of an enumerator.
  struct Comparison {
    Relation relation = Relation::kEqual;
    std::string value;
    std::string unit;  ///< empty: that of the column
  };

  std::string text;  ///< as typed
  Path path;
  std::optional<Comparison> comparison;  ///< empty: an event
};

/// kInvalid with the column of the mistake, counted from 1.
Result<Condition> ParseCondition(std::string_view text);

/// A comparison of one number in a column, ready to be evaluated for each row.
///
/// Thread safety: immutable.
class CellTest {
 public:
  /// `condition` has a comparison, and `column` is the type of its column. kNotFound if the type
  /// has no such field, kInvalid for another unit, or a value or relation that does not fit it.
  static Result<CellTest> Make(const Condition& condition, const Schema& column);

  /// False also if the cell has no value, or the value is not-a-number (but not-a-number is != to
  /// any number). A load and a comparison.
  [[nodiscard]] bool IsTrue(std::span<const std::byte> cell) const;

 private:
  CellTest(NumericField field, Condition::Relation relation, long double value)
      : field_(std::move(field)), relation_(relation), value_(value) {}

  NumericField field_;
  Condition::Relation relation_;
  long double value_;  // holds every integer of 64 bits
};

}  // namespace tendon::recording
