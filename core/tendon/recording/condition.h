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
#include <utility>

namespace tendon::recording {

/// A condition that begins or ends a recording, in the form that a user types: an event, such as
/// "robot/arm/Control.GoalReached", an executed call of a command, such as
/// "robot/arm/Control.MoveTo", or a comparison of a column of a state table, such as
/// "robot/arm/state.Joints.position[2] > 1.2 rad". A Trigger watches it.
struct Condition {
  enum class Relation { kLess, kLessOrEqual, kGreater, kGreaterOrEqual, kEqual, kNotEqual };
  /// The right side is a number, true, false, or the name of an enumerator.
  struct Comparison {
    Relation relation = Relation::kEqual;
    std::string value;
    std::string unit;  ///< empty: the unit of the column
  };

  std::string text;  ///< as typed
  Path path;
  std::optional<Comparison> comparison;  ///< empty: an event or a command
};

/// Parses a condition. Fails with kInvalid if the text has a mistake; the error names the column of
/// the text, counted from 1.
Result<Condition> ParseCondition(std::string_view text);

/// A comparison of one number in a column, ready to be evaluated for each row. The trigger calls it
/// in the thread that receives the rows.
///
/// Thread safety: immutable, so any thread.
class CellTest {
 public:
  /// `condition` must have a comparison; `column` is the type of its column. Fails with kNotFound
  /// if the type has no such field. Fails with kInvalid if the unit differs, or if the value or the
  /// relation does not fit the type.
  static Result<CellTest> Make(const Condition& condition, const Schema& column);

  /// Also returns false if the cell has no value. For NaN, only `!=` is true. Cost: a load and a
  /// comparison.
  [[nodiscard]] bool IsTrue(std::span<const std::byte> cell) const;

 private:
  CellTest(NumericField field, Condition::Relation relation, long double value)
      : field_(std::move(field)), relation_(relation), value_(value) {}

  NumericField field_;
  Condition::Relation relation_;
  long double value_;  // holds every integer of 64 bits
};

}  // namespace tendon::recording
