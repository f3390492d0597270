#pragma once

#include <tendon/base/name.h>
#include <tendon/interface/interface_description.h>
#include <tendon/payload/numeric_field.h>

#include <QString>
#include <QStringList>
#include <cstdint>
#include <optional>
#include <string_view>

namespace tendon {
struct ConnectionCounts;
}

/// Formats numbers and times for tables: short, of constant width, independent of the locale.
namespace tendon::gui {

[[nodiscard]] QString ToQString(std::string_view text);
/// "desk/teleoperation/Robot".
[[nodiscard]] QString ToQString(const InterfaceName& name);

/// "0.2013", "-1.250", "1764300000", "1.200e+15", "12": integers unchanged, other numbers with at
/// least four significant digits.
[[nodiscard]] QString NumberText(double value);

/// The text of a number, and its unit, which may be empty.
struct Quantity {
  QString number;
  QString unit;
};

/// A number formatted as its field requires: "on", "true", "12", "0.2013" "rad"; "–" for none.
/// Integers keep all digits. Durations below a second get a suitable unit: "19.6" "µs".
[[nodiscard]] Quantity QuantityOf(const NumericField& field,
                                  const std::optional<NumericValue>& value);

/// All digits with the unit, if QuantityOf() rounds: "0.20134000000000002 rad"; otherwise empty.
[[nodiscard]] QString WholeText(const NumericField& field,
                                const std::optional<NumericValue>& value);

/// The rate of a period in seconds: "1 kHz", "50 Hz", "0.5 Hz"; empty for none.
[[nodiscard]] QString RateOfPeriodText(double period);

/// A duration in seconds: "420 ns", "38.0 µs", "1.000 ms", "2.50 s".
[[nodiscard]] QString DurationText(double seconds);

/// An age from nanoseconds: "12 s", "3 min", "2 h".
[[nodiscard]] QString AgeText(std::int64_t nanoseconds);

/// The time of day of `when`, ns since 1970: "12:04:31.208".
[[nodiscard]] QString ClockText(std::int64_t when);

/// "1 client", "3 clients", "" for none; from "%1 client" and "%1 clients".
[[nodiscard]] QString CountText(std::int64_t count, const QString& one, const QString& many);

/// The types of argument and result: "JointGoal", "LinkId → Pose", "" for neither. With whole names
/// "arm.LinkId → geometry_msgs.Pose".
enum class TypeNames { kShort, kWhole };
[[nodiscard]] QString TypesText(const MemberDescription& member, TypeNames names);

/// "Ends unless called again within 100 ms"; empty for a command whose effect does not expire.
[[nodiscard]] QString ExpiryText(const MemberDescription& member);

/// Quotes a word for a shell: 'it'\''s' for "it's".
[[nodiscard]] QString ShellWord(QString word);

/// The shell command for a call: "gcm call robot/arm/Control.MoveTo '{...}'".
[[nodiscard]] QString CallLine(const QString& path, const QString& json);

/// The present time in ns since 1970, like ProcessDescription::since.
[[nodiscard]] std::int64_t WallClock();

/// All counters of a connection, one sentence per line.
[[nodiscard]] QStringList CountsLines(const ConnectionCounts& counts);

}  // namespace tendon::gui
