#pragma once

#include <tendon/interface/description.h>
#include <tendon/payload/plot_channel.h>

#include <QString>
#include <cstdint>
#include <optional>
#include <string_view>

/// Numbers and times as the window's tables show them: short, of steady width, without locale.
namespace tendon::gui {

[[nodiscard]] QString ToQString(std::string_view text);

/// "0.2013", "-1.250", "1764300000", "1.200e+15", "12": integers as they are, else four significant
/// digits at least.
[[nodiscard]] QString NumberText(double value);

/// What is shown of a number, and the unit behind it, which may be empty.
struct Quantity {
  QString number;
  QString unit;
};

/// A number as its channel means it: "on", "true", "12", "0.2013" "rad"; "–" for none. Integers
/// have all their digits. Parts of a second come in the unit that fits: "19.6" "µs".
[[nodiscard]] Quantity QuantityOf(const PlotChannel& channel,
                                  const std::optional<ChannelValue>& value);

/// All digits of it with the unit, where QuantityOf() has rounded: "0.20134000000000002 rad"; empty
/// where it has not.
[[nodiscard]] QString WholeText(const PlotChannel& channel,
                                const std::optional<ChannelValue>& value);

/// Of a period in seconds: "1 kHz", "50 Hz", "0.5 Hz"; empty for none.
[[nodiscard]] QString RateOfPeriodText(double period);

/// A duration in seconds: "420 ns", "38.0 µs", "1.000 ms", "2.50 s".
[[nodiscard]] QString DurationText(double seconds);

/// How long ago, from nanoseconds: "12 s", "3 min", "2 h".
[[nodiscard]] QString AgeText(std::int64_t nanoseconds);

/// The time of day of `when`, ns since 1970: "12:04:31.208".
[[nodiscard]] QString ClockText(std::int64_t when);

/// "1 client", "3 clients", "" for none: of "%1 client" and "%1 clients".
[[nodiscard]] QString CountText(std::int64_t count, const QString& one, const QString& many);

/// What goes in and comes out: "JointGoal", "LinkId → Pose", "" for neither. With the whole names
/// "arm.LinkId → geometry_msgs.Pose".
enum class TypeNames { kShort, kWhole };
[[nodiscard]] QString TypesText(const MemberDescription& member, TypeNames names);

/// "Ends unless called again within 100 ms"; empty for a command that does not end by itself.
[[nodiscard]] QString ExpiryText(const MemberDescription& member);

/// As one word of a shell: 'it'\''s' for "it's".
[[nodiscard]] QString ShellWord(QString word);

/// The line that calls it in a terminal: "gcm call robot/arm/Control.MoveTo '{...}'".
[[nodiscard]] QString CallLine(const QString& path, const QString& json);

/// Now, in ns since 1970, as ProcessDescription::since counts.
[[nodiscard]] std::int64_t WallClock();

}  // namespace tendon::gui
