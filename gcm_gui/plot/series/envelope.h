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

/// A curve as it appears on a screen. For each time slice, it has the minimum and the maximum of
/// the line through the samples. This line is straight between real numbers; an integer holds its
/// value until the next sample.
/// The extreme values of all samples are kept. The line is interrupted at gaps and at values that
/// are not finite. All values are distances from a base: a double cannot distinguish large
/// integers, but it can hold their distance from a base near them.
class Envelope {
 public:
  /// Builds the envelope; always pass the same ring. O(samples in the slices + slices). If the
  /// slices have moved by a whole number of slices, as in a live plot, only the new part is
  /// computed: O(new samples + slices). If the base has changed, the whole envelope is built again.
  void build(const SampleRing& ring, const TimeSlices& slices, double base = 0);

  /// Adds the minimum and maximum of [from_ns, to_ns), a span whose samples no longer exist. The
  /// next build() removes this addition. O(slices in the span).
  void widen(std::int64_t from_ns, std::int64_t to_ns, double low, double high);

  /// Makes this object a scaled copy of `plain`, which must have base 0; the values are then
  /// relative to `base`. Never call build() on this object. A slice whose result is not finite is
  /// empty. O(slices).
  void takeScaled(const Envelope& plain, const Scaling& scaling, double base);

  [[nodiscard]] std::span<const double> low() const { return shown(low_); }
  /// The maxima. In an empty slice, high() is lower than low().
  [[nodiscard]] std::span<const double> high() const { return shown(high_); }

  // lowest() and highest() cover all slices. If all slices are empty, lowest() > highest().
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

  // The arrays have one more hidden slice at each end, for all earlier and all later times.
  std::vector<std::int64_t> ends_;
  std::vector<double> low_;
  std::vector<double> high_;
  double lowest_ = 0;
  double highest_ = 0;

  // The arguments and the state of the last build().
  TimeSlices slices_;
  double base_ = 0;
  std::uint64_t ring_first_ = 0;
  std::uint64_t next_ = 0;  // index of the next sample
};

}  // namespace tendon::gui
