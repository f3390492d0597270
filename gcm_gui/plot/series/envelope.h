#pragma once

#include <gcm_gui/plot/series/sample_ring.h>
#include <gcm_gui/plot/series/scaling.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tendon::gui {

/// A division of the time [from_ns, to_ns) into slices of equal width.
struct TimeSlices {
  std::int64_t from_ns = 0;
  std::int64_t to_ns = 0;
  std::size_t count = 0;

  bool operator==(const TimeSlices&) const = default;
};

/// A curve as a screen shows it: the minimum and maximum in each time slice of the line through the
/// samples. Straight lines join real numbers; integers hold their value until the next sample.
///
/// No extreme value of a sample is lost. The line ends at gaps and at values that are not finite.
/// All values are distances from a base, because doubles cannot distinguish large integers.
class Envelope {
 public:
  /// Always pass the same ring. O(samples in the slices + slices). If the slices have moved by a
  /// whole number of slices, as in a live plot, O(new samples + slices). Starts over if the base
  /// has changed.
  void build(const SampleRing& ring, const TimeSlices& slices, double base = 0);

  /// Adds a known minimum and maximum of [from_ns, to_ns), whose samples no longer exist. Valid
  /// until the next build(). O(slices in that span).
  void widen(std::int64_t from_ns, std::int64_t to_ns, double low, double high);

  /// Takes the content of `plain`, which must have base 0, scaled and relative to `base`. Never
  /// call build() on this object. A slice without a finite result is empty. O(slices).
  void takeScaled(const Envelope& plain, const Scaling& scaling, double base);

  [[nodiscard]] std::span<const double> low() const { return shown(low_); }
  /// Lower than low() in an empty slice.
  [[nodiscard]] std::span<const double> high() const { return shown(high_); }

  // Over all slices; lowest() > highest() if all are empty.
  [[nodiscard]] double lowest() const { return lowest_; }
  [[nodiscard]] double highest() const { return highest_; }

 private:
  struct Pen;

  bool moveOn(const SampleRing& ring, const TimeSlices& slices);
  void start(const SampleRing& ring, const TimeSlices& slices);
  void placeEnds(const TimeSlices& slices);
  void drawUntil(const SampleRing& ring, std::int64_t time_ns);
  void draw(const SampleRing& ring, std::uint64_t from, std::uint64_t to);
  template <typename Reader>
  void draw(SampleRing::Segment segment, const Reader& read, Pen& pen);
  void moveTo(Pen& pen, std::int64_t time_ns, double value);
  void lineTo(Pen& pen, std::int64_t time_ns, double value);
  void stepTo(Pen& pen, std::int64_t time_ns, double value);
  static void enter(Pen& pen, std::size_t slice, double value);
  void leave(const Pen& pen);
  [[nodiscard]] static std::span<const double> shown(const std::vector<double>& all) {
    return all.empty() ? std::span<const double>() : std::span(all).subspan(1, all.size() - 2);
  }

  // With one hidden slice more at either side, for all earlier and all later time.
  std::vector<std::int64_t> ends_;
  std::vector<double> low_;
  std::vector<double> high_;
  double lowest_ = 0;
  double highest_ = 0;

  // The state of the last build().
  TimeSlices slices_;
  double base_ = 0;
  std::uint64_t ring_first_ = 0;
  std::uint64_t next_ = 0;  // index of the next sample
};

}  // namespace tendon::gui
