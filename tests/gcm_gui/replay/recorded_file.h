#pragma once

#include <QString>
#include <cstdint>
#include <memory>

namespace tendon::gui {

inline constexpr std::int64_t kSecond = 1'000'000'000;  // ns
inline constexpr std::int64_t kRunBegin = 1'714'550'400 * kSecond;

enum class FileEnd { kComplete, kMissing };

/// Writes a recording of 20 s: the system of the look, in which
/// - `robot/arm/state.Joints` has 100 rows a second: position[0] is the time in s since the begin,
///   position[1] a wave; 50 rows are lost at 10 s;
/// - `robot/arm/state.Temperature` has one value, at the begin;
/// - `robot/arm/Drives.LimitExceeded` is raised at 5 s, 9 s and 15 s, with that number;
/// - teleoperation is connected with the controller at 8 s; the arm is suspended at 12 s, and
/// active
///   again at 16 s;
/// - the log has a record at 1 s and at 12 s, and at 3 s a call by desk of
/// robot/arm/Control.MoveTo.
/// Without its end, the last tenth is missing.
void WriteRun(const QString& file, FileEnd end = FileEnd::kComplete);

/// Writes the same, and goes on writing it until the result is released.
[[nodiscard]] std::shared_ptr<void> BeginRun(const QString& file);

/// Writes a recording of 0.1 s: `robot/arm/state.Joints` has 100 rows a second. The first five have
/// position[0] = 1; then the source is another program, whose type begins with another field, and
/// position[0] is 3.
void WriteTwoTypes(const QString& file);

}  // namespace tendon::gui
