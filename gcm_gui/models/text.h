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
/// Returns the path of an interface: "desk/teleoperation/Robot".
[[nodiscard]] QString ToQString(const InterfaceName& name);

/// Formats a number: "0.2013", "-1.250", "1764300000", "1.200e+15", "12". Whole numbers keep their
/// digits, other numbers get at least four significant digits.
[[nodiscard]] QString NumberText(double value);

/// The text of a number, and its unit, which may be empty.
struct Quantity {
  QString number;
  QString unit;
};

/// Formats a number as its field requires: "on", "true", "12", "0.2013" "rad"; "–" if there is no
/// value. Integers keep all digits. Durations below a second get a suitable unit: "19.6" "µs".
[[nodiscard]] Quantity QuantityOf(const NumericField& field,
                                  const std::optional<NumericValue>& value);

/// Returns all digits with the unit if QuantityOf() rounds the value: "0.20134000000000002 rad";
/// otherwise an empty text.
[[nodiscard]] QString WholeText(const NumericField& field,
                                const std::optional<NumericValue>& value);

/// Returns the rate for a period in seconds: "1 kHz", "50 Hz", "0.5 Hz"; empty if there is no
/// period.
[[nodiscard]] QString RateOfPeriodText(double period);

/// Formats a duration in seconds: "420 ns", "38.0 µs", "1.000 ms", "2.50 s".
[[nodiscard]] QString DurationText(double seconds);

/// Formats an age in nanoseconds: "12 s", "3 min", "2 h", "5 d".
[[nodiscard]] QString AgeText(std::int64_t nanoseconds);

/// Formats the time of day of `when`, in ns since 1970: "12:04:31.208".
[[nodiscard]] QString ClockText(std::int64_t when);

/// Formats a count with one of two texts, such as "%1 client" and "%1 clients": "1 client", "3
/// clients"; empty for 0.
[[nodiscard]] QString CountText(std::int64_t count, const QString& one, const QString& many);

/// The form in which a signature names the types of argument and result: short "LinkId → Pose", or
/// whole "arm.LinkId → geometry_msgs.Pose".
enum class TypeNames { kShort, kWhole };
[[nodiscard]] QString TypesText(const MemberDescription& member, TypeNames names);

/// Returns "The action ends unless the command is called again within 100 ms"; empty for a command
/// whose effect does not expire.
[[nodiscard]] QString ExpiryText(const MemberDescription& member);

/// Quotes a word for a shell: 'it'\''s' for "it's".
[[nodiscard]] QString ShellWord(QString word);

/// Returns the shell command for a call: "gcm call robot/arm/Control.MoveTo '{...}'".
[[nodiscard]] QString CallLine(const QString& path, const QString& json);

/// Returns the present time in ns since 1970, as in ProcessDescription::since.
[[nodiscard]] std::int64_t WallClock();

/// Returns all counters of a connection, one sentence per line.
[[nodiscard]] QStringList CountsLines(const ConnectionCounts& counts);

}  // namespace tendon::gui
