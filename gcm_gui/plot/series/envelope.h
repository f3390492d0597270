#pragma once

#include <gcm_gui/plot/scaling/scaling.h>
#include <gcm_gui/plot/series/sample_ring.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tendon::gui {

/// Equally wide slices of the time [from_ns, to_ns).
struct TimeSlices {
  std::int64_t from_ns = 0;
  std::int64_t to_ns = 0;
  std::size_t count = 0;

  bool operator==(const TimeSlices&) const = default;
};

/// A curve as a screen can show it: in each slice of time the lowest and the highest value that the
/// line through the samples has there. Reals are joined by straight lines; integers hold their
/// value until the next sample, and step to it.
///
/// No extreme of a sample is left out. The line ends at gaps and at values that are not finite.
/// All values are distances from a base, as doubles cannot tell large integers apart.
class Envelope {
 public:
  /// Always with the same ring. O(samples in the slices + slices); where the slices have moved on
  /// by whole ones since the last time, as they do in a live plot, O(new samples + slices).
  /// Another base than the last time draws all anew.
  void build(const SampleRing& ring, const TimeSlices& slices, double base = 0);

  /// What is known of [from_ns, to_ns) without its samples is shown, too, until the next build()
  /// at least. O(slices there).
  void widen(std::int64_t from_ns, std::int64_t to_ns, double low, double high);

  /// Is that of the scaled curve until the next call; never build() the same one. What has no
  /// finite value then is empty. `plain` has the base 0, this one `base`. O(slices).
  void takeScaled(const Envelope& plain, const Scaling& scaling, double base);

  [[nodiscard]] std::span<const double> low() const { return shown(low_); }
  /// Lower than low() where a slice is empty.
  [[nodiscard]] std::span<const double> high() const { return shown(high_); }

  // Of all slices; lowest() > highest() when all are empty.
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
  void draw(SampleRing::Stretch stretch, const Reader& read, Pen& pen);
  void moveTo(Pen& pen, std::int64_t time_ns, double value);
  void lineTo(Pen& pen, std::int64_t time_ns, double value);
  void stepTo(Pen& pen, std::int64_t time_ns, double value);
  static void enter(Pen& pen, std::size_t slice, double value);
  void leave(const Pen& pen);
  [[nodiscard]] static std::span<const double> shown(const std::vector<double>& all) {
    return all.empty() ? std::span<const double>() : std::span(all).subspan(1, all.size() - 2);
  }

  // With one slice more at either side, which is not shown: all time before, and all behind.
  std::vector<std::int64_t> ends_;
  std::vector<double> low_;
  std::vector<double> high_;
  double lowest_ = 0;
  double highest_ = 0;

  // What has been drawn.
  TimeSlices slices_;
  double base_ = 0;
  std::uint64_t ring_first_ = 0;
  std::uint64_t next_ = 0;  // sample
};

}  // namespace tendon::gui
