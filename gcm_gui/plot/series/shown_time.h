#pragma once

#include <QString>
#include <cstdint>

/// The present time of the system that this program shows. All code that compares the time of a
/// value with the present uses this function, so that a recording looks like the system at the
/// recorded moment.
namespace tendon::gui {

/// A moment on two clocks.
struct ShownMoment {
  std::int64_t steady_ns = 0;  ///< the clock of samples
  std::int64_t wall_ns = 0;    ///< since 1970
  QString recording = {};      ///< its file
};

/// Returns the time on this machine's steady clock, in ns; in a program that shows a recording, the
/// moment of the recording.
[[nodiscard]] std::int64_t ShownTime();
/// Likewise the time in ns since 1970.
[[nodiscard]] std::int64_t ShownWallTime();
/// Returns the time since 1970 minus the time of ShownTime(), in ns. It is constant, even if the
/// clock of the machine is set.
[[nodiscard]] std::int64_t WallOffset();
/// Returns the file of the recording that this program shows; empty if it shows none.
[[nodiscard]] QString ShownRecording();
/// From now on, the present is this moment of a recording. GUI thread.
void ShowMoment(const ShownMoment& moment);
/// From now on, the present is the time of this machine. GUI thread.
void ShowPresent();
/// True between ShowMoment() and ShowPresent().
[[nodiscard]] bool IsMomentShown();

}  // namespace tendon::gui
