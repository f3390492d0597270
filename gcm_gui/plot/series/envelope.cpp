#include <gcm_gui/plot/series/envelope.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace tendon::gui {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

bool IsFinite(double value) { return std::abs(value) <= std::numeric_limits<double>::max(); }

// These types convert stored words to values while drawing. Almost all plots use the type Real; its
// conversion costs nothing.
struct Real {
  static constexpr bool kSteps = false;
  double operator()(std::uint64_t word) const { return std::bit_cast<double>(word); }
};

struct RealFromBase {
  static constexpr bool kSteps = false;
  double base;
  double operator()(std::uint64_t word) const { return std::bit_cast<double>(word) - base; }
};

struct IntegerFromBase {
  static constexpr bool kSteps = true;
  DistanceFrom distance;
  double operator()(std::uint64_t word) const { return distance(word); }
};

// Interpolates between two points whose distance does not fit a double.
double FarBetween(double from, double to, double part) { return from * (1 - part) + to * part; }

}  // namespace

// The state of drawing: the point that the line has reached, and the extremes in the present slice.
struct Envelope::Pen {
  bool down = false;
  std::int64_t time_ns = 0;
  double value = 0;
  std::size_t slice = 0;
  double low = 0;
  double high = 0;
};

void Envelope::build(const SampleRing& ring, const TimeSlices& slices, double base) {
  const bool is_same_base = std::exchange(base_, base) == base;
  if (!is_same_base || !moveOn(ring, slices)) start(ring, slices);
  slices_ = slices;
  ring_first_ = ring.firstIndex();
  placeEnds(slices);
  drawUntil(ring, slices.to_ns);
  lowest_ = kEndless;
  highest_ = -kEndless;
  for (const double each : low()) lowest_ = std::min(lowest_, each);
  for (const double each : high()) highest_ = std::max(highest_, each);
}

void Envelope::widen(std::int64_t from_ns, std::int64_t to_ns, double low, double high) {
  const std::int64_t from = std::max(from_ns, slices_.from_ns);
  const std::int64_t to = std::min(to_ns, slices_.to_ns);
  if (from >= to || slices_.count == 0) return;
  const double width =
      static_cast<double>(slices_.to_ns - slices_.from_ns) / static_cast<double>(slices_.count);
  const auto slice_of = [&](std::int64_t time_ns) {
    const double place = static_cast<double>(time_ns - slices_.from_ns) / width;
    return std::min(static_cast<std::size_t>(place), slices_.count - 1) + 1;
  };
  for (std::size_t slice = slice_of(from); slice <= slice_of(to - 1); ++slice) {
    low_[slice] = std::min(low_[slice], low);
    high_[slice] = std::max(high_[slice], high);
  }
  lowest_ = std::min(lowest_, low);
  highest_ = std::max(highest_, high);
}

void Envelope::takeScaled(const Envelope& plain, const Scaling& scaling, double base) {
  low_ = plain.low_;
  high_ = plain.high_;
  lowest_ = kEndless;
  highest_ = -kEndless;
  for (std::size_t i = 0; i < low_.size(); ++i) {
    const auto [low, high] = std::minmax({scaling.of(low_[i]), scaling.of(high_[i])});
    const bool is_empty = low_[i] > high_[i] || !IsFinite(low) || !IsFinite(high);
    low_[i] = is_empty ? kEndless : low - base;
    high_[i] = is_empty ? -kEndless : high - base;
  }
  for (const double each : low()) lowest_ = std::min(lowest_, each);
  for (const double each : high()) highest_ = std::max(highest_, each);
}

void Envelope::start(const SampleRing& ring, const TimeSlices& slices) {
  low_.assign(slices.count + 2, kEndless);
  high_.assign(slices.count + 2, -kEndless);
  // Starts one sample before the slices, because the line may enter them between two samples.
  next_ = std::max(ring.lowerBound(slices.from_ns), ring.firstIndex() + 1) - 1;
}

// Shifts the existing slices to the left. Returns false if this is not possible and the envelope
// must be built again.
bool Envelope::moveOn(const SampleRing& ring, const TimeSlices& slices) {
  constexpr std::int64_t kRoundingNs = 2;
  const std::int64_t by_ns = slices.from_ns - slices_.from_ns;
  const double width = static_cast<double>(slices_.to_ns - slices_.from_ns) /
                       static_cast<double>(std::max<std::size_t>(slices_.count, 1));
  const double by = std::round(static_cast<double>(by_ns) / width);
  const bool as_wide = slices.count == slices_.count &&
                       std::abs(slices.to_ns - slices_.to_ns - by_ns) <= kRoundingNs;
  const bool by_whole_ones = std::abs(by * width - static_cast<double>(by_ns)) <= kRoundingNs;
  if (!as_wide || !by_whole_ones || by < 0 || by >= static_cast<double>(slices.count)) return false;
  // The last part of the line may have ended after the slices, so it must be drawn again.
  if (next_ < ring.firstIndex() + 2) return false;
  const bool shown_samples_left = ring.firstIndex() != ring_first_ &&
                                  (ring.empty() || ring.time(ring.firstIndex()) > slices.from_ns);
  if (shown_samples_left) return false;
  next_ -= 2;
  const auto count = static_cast<std::ptrdiff_t>(by);
  for (auto [values, empty] : {std::pair(&low_, kEndless), std::pair(&high_, -kEndless)}) {
    std::fill(std::copy(values->begin() + 1 + count, values->end() - 1, values->begin() + 1),
              values->end(), empty);
  }
  return true;
}

void Envelope::placeEnds(const TimeSlices& slices) {
  ends_.clear();
  const double width = static_cast<double>(slices.to_ns - slices.from_ns) /
                       static_cast<double>(std::max<std::size_t>(slices.count, 1));
  for (std::size_t i = 0; i <= slices.count; ++i) {
    const double end = static_cast<double>(i) * width + 0.5;
    ends_.push_back(slices.from_ns + static_cast<std::int64_t>(end));
  }
  ends_.push_back(std::numeric_limits<std::int64_t>::max());
}

// Draws one sample after `time_ns`, because the line may leave the slices between two samples.
void Envelope::drawUntil(const SampleRing& ring, std::int64_t time_ns) {
  const std::uint64_t to = std::min(ring.lowerBound(time_ns) + 1, ring.endIndex());
  const auto& gaps = ring.gaps();
  auto gap =
      std::upper_bound(gaps.begin(), gaps.end(), next_,
                       [](std::uint64_t index, const Gap& each) { return index < each.index; });
  for (; gap != gaps.end() && gap->index < to; ++gap) {
    draw(ring, next_, gap->index);
    next_ = gap->index;
  }
  draw(ring, next_, to);
  next_ = std::max(next_, to);
}

void Envelope::draw(const SampleRing& ring, std::uint64_t from, std::uint64_t to) {
  Pen pen;
  while (from < to) {
    const SampleRing::Segment segment = ring.segment(from, to);
    if (ring.kind() != ExactNumber::Kind::kReal) {
      draw(segment, IntegerFromBase{DistanceFrom(ring.kind(), base_)}, pen);
    } else if (base_ != 0) {
      draw(segment, RealFromBase{base_}, pen);
    } else {
      draw(segment, Real{}, pen);
    }
    from += segment.times.size();
  }
  if (pen.down) leave(pen);
}

template <typename Reader>
void Envelope::draw(SampleRing::Segment segment, const Reader& read, Pen& pen) {
  const auto [times, words] = segment;
  std::size_t i = 0;
  while (i < times.size()) {
    const double first = read(words[i]);
    if (!IsFinite(first)) {
      if (pen.down) leave(pen);
      pen.down = false;
      ++i;
      continue;
    }
    if (!pen.down) {
      moveTo(pen, times[i], first);
    } else if constexpr (Reader::kSteps) {
      stepTo(pen, times[i], first);
    } else {
      lineTo(pen, times[i], first);
    }
    // A fast path for more samples in the same slice: first four at a time, then one by one.
    double low = pen.low;
    double high = pen.high;
    const std::int64_t end = ends_[pen.slice];
    for (++i; i + 4 <= times.size() && times[i + 3] < end; i += 4) {
      const std::array v{read(words[i]), read(words[i + 1]), read(words[i + 2]),
                         read(words[i + 3])};
      const double zero = (v[0] - v[0]) + (v[1] - v[1]) + (v[2] - v[2]) + (v[3] - v[3]);
      if (zero != 0) break;  // the sum is NaN if one of the four values is not finite
      low = std::min(low, std::min(std::min(v[0], v[1]), std::min(v[2], v[3])));
      high = std::max(high, std::max(std::max(v[0], v[1]), std::max(v[2], v[3])));
    }
    double last = read(words[i - 1]);
    for (; i < times.size() && times[i] < end; ++i) {
      const double value = read(words[i]);
      if (!IsFinite(value)) break;
      low = std::min(low, value);
      high = std::max(high, value);
      last = value;
    }
    pen.low = low;
    pen.high = high;
    pen.time_ns = times[i - 1];
    pen.value = last;
  }
}

void Envelope::moveTo(Pen& pen, std::int64_t time_ns, double value) {
  const auto end = std::upper_bound(ends_.begin(), ends_.end() - 1, time_ns);
  enter(pen, static_cast<std::size_t>(end - ends_.begin()), value);
  pen.down = true;
  pen.time_ns = time_ns;
  pen.value = value;
}

// Extends the line through all slices up to the point. The value at the border of two slices
// belongs to both.
void Envelope::lineTo(Pen& pen, std::int64_t time_ns, double value) {
  if (time_ns >= ends_[pen.slice]) {
    const auto span_ns = static_cast<double>(time_ns - pen.time_ns);
    const double slope = (value - pen.value) / span_ns;
    const double least = std::min(pen.value, value);
    const double most = std::max(pen.value, value);
    while (time_ns >= ends_[pen.slice]) {
      const auto way_ns = static_cast<double>(ends_[pen.slice] - pen.time_ns);
      const double there = IsFinite(slope) ? pen.value + slope * way_ns
                                           : FarBetween(pen.value, value, way_ns / span_ns);
      // Rounding may put `there` outside of the two values.
      const double border = std::clamp(there, least, most);
      pen.low = std::min(pen.low, border);
      pen.high = std::max(pen.high, border);
      leave(pen);
      enter(pen, pen.slice + 1, border);
    }
  }
  pen.low = std::min(pen.low, value);
  pen.high = std::max(pen.high, value);
  pen.time_ns = time_ns;
  pen.value = value;
}

// Extends the line horizontally through all slices up to the point, then vertically in the last
// slice.
void Envelope::stepTo(Pen& pen, std::int64_t time_ns, double value) {
  while (time_ns >= ends_[pen.slice]) {
    leave(pen);
    enter(pen, pen.slice + 1, pen.value);
  }
  pen.low = std::min(pen.low, value);
  pen.high = std::max(pen.high, value);
  pen.time_ns = time_ns;
  pen.value = value;
}

void Envelope::enter(Pen& pen, std::size_t slice, double value) {
  pen.slice = slice;
  pen.low = value;
  pen.high = value;
}

void Envelope::leave(const Pen& pen) {
  low_[pen.slice] = std::min(low_[pen.slice], pen.low);
  high_[pen.slice] = std::max(high_[pen.slice], pen.high);
}

}  // namespace tendon::gui
