#include <gcm_gui/plot/series/curve_set.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tendon::gui {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr AxisRange kNothing{.low = kInfinity, .high = -kInfinity};
constexpr double kDecadesAboveZero = 6;

// A curve with values above both limits does not count when its axis is fitted.
constexpr double kOrdinary = 1e12;
constexpr double kMaxTimes = 1e6;

AxisRange United(const AxisRange& a, const AxisRange& b) {
  return {.low = std::min(a.low, b.low), .high = std::max(a.high, b.high)};
}

UnitAxis* AxisFor(std::vector<UnitAxis>& axes, const QString& unit) {
  const auto found = std::find_if(axes.begin(), axes.end(),
                                  [&](const UnitAxis& axis) { return axis.unit == unit; });
  return found == axes.end() ? nullptr : &*found;
}

// For an enumeration with only a few states, the axis shows all states, so that the axis does not
// move.
AxisRange WithAllStates(const AxisRange& data, const ValueNames& names) {
  constexpr double kFew = 12;
  if (names.all.empty()) return data;
  const AxisRange all{.low = static_cast<double>(names.all.front().value),
                      .high = static_cast<double>(names.all.back().value)};
  return all.span() <= kFew ? United(data, all) : data;
}

double PresentRate(const Curve& curve, std::int64_t now_ns) {
  const double rate = curve.rate();
  const SampleRing& samples = curve.samples();
  if (rate <= 0) return 0;
  const auto silence = static_cast<double>(now_ns - samples.time(samples.endIndex() - 1));
  return silence > std::max(1e9, 2e9 / rate) ? 0 : rate;
}

}  // namespace

Curve& CurveSet::add(const CurveKey& key) {
  if (Curve* there = find(key.path)) return *there;
  curves_.push_back(std::make_unique<Curve>(key, colorFor(key.path)));
  updateAxes();
  return *curves_.back();
}

bool CurveSet::remove(const QString& path) {
  const bool removed =
      std::erase_if(curves_, [&](const auto& curve) { return curve->path() == path; }) > 0;
  updateAxes();
  return removed;
}

std::unique_ptr<Curve> CurveSet::take(const QString& path) {
  const auto found = std::find_if(curves_.begin(), curves_.end(),
                                  [&](const auto& curve) { return curve->path() == path; });
  if (found == curves_.end()) return nullptr;
  std::unique_ptr<Curve> taken = std::move(*found);
  curves_.erase(found);
  updateAxes();
  return taken;
}

Curve& CurveSet::adopt(std::unique_ptr<Curve> curve) {
  curve->setColorIndex(colorFor(curve->path()));
  curves_.push_back(std::move(curve));
  updateAxes();
  return *curves_.back();
}

void CurveSet::setLook(Curve& curve, const CurveLook& look) {
  curve.setLook(look);
  updateAxes();
  UnitAxis& axis = *AxisFor(axes_, curve.axis());
  axis.fitted = true;
  axis.has_grown = false;
}

void CurveSet::setNames(Curve& curve, ValueNamesPointer names) {
  const QString before = curve.axis();
  curve.setNames(std::move(names));
  updateAxes();
  if (curve.axis() == before) return;
  UnitAxis& axis = *AxisFor(axes_, curve.axis());
  axis.fitted = true;
  axis.has_grown = false;
}

Curve* CurveSet::find(const QString& path) const {
  const auto found = std::find_if(curves_.begin(), curves_.end(),
                                  [&](const auto& curve) { return curve->path() == path; });
  return found == curves_.end() ? nullptr : found->get();
}

const UnitAxis& CurveSet::axisOf(const Curve& curve) const {
  return *std::find_if(axes_.begin(), axes_.end(),
                       [&](const UnitAxis& axis) { return axis.unit == curve.axis(); });
}

void CurveSet::updateAxes() {
  std::vector<UnitAxis> axes;
  for (const auto& curve : curves_) {
    const QString name = curve->axis();
    if (UnitAxis* shared = AxisFor(axes, name)) {
      shared->color_index = -1;
      const bool is_named_alike = shared->names != nullptr && curve->names() != nullptr &&
                                  *shared->names == *curve->names();
      if (!is_named_alike) shared->names.reset();
      continue;
    }
    const UnitAxis* there = AxisFor(axes_, name);
    axes.push_back(there != nullptr ? *there : UnitAxis{.unit = name});
    axes.back().color_index = curve->colorIndex();
    axes.back().names = curve->names() != nullptr ? curve->allNames() : nullptr;
  }
  axes_ = std::move(axes);
  showBases();
}

void CurveSet::showBases() {
  for (const auto& curve : curves_) curve->setBase(axisOf(*curve).frame.base);
}

void CurveSet::setFrame(UnitAxis& axis, const AxisFrame& frame) {
  if (frame == axis.frame) return;
  axis.range = Moved(axis.range, axis.frame, frame);
  axis.grown = Moved(axis.grown, axis.frame, frame);
  axis.frame = frame;
  showBases();
}

// Returns the colour for a new curve. A live curve and a recorded curve of the same signal have the
// same colour; any other curve gets the first free colour. If there are more curves than colours,
// colours repeat.
int CurveSet::colorFor(const QString& path) const {
  std::vector<const Curve*> twins;
  for (const auto& curve : curves_) {
    const bool is_twin = curve->path() != path && SignalOf(curve->path()) == SignalOf(path);
    if (is_twin) twins.push_back(curve.get());
  }
  if (twins.size() == 1 && twins.front()->isRecorded() == RecordingOf(path).isEmpty()) {
    return twins.front()->colorIndex();
  }
  int color = 0;
  const auto taken = [&](const auto& curve) { return curve->colorIndex() == color; };
  while (std::any_of(curves_.begin(), curves_.end(), taken)) ++color;
  return color;
}

void CurveSet::fitAll() {
  for (UnitAxis& axis : axes_) axis.fitted = true;
}

bool CurveSet::isFitted() const {
  return std::all_of(axes_.begin(), axes_.end(), [](const UnitAxis& axis) { return axis.fitted; });
}

void CurveSet::setFit(Fit fit) {
  fit_ = fit;
  for (UnitAxis& axis : axes_) {
    axis.fitted = true;
    axis.has_grown = false;
  }
}

void CurveSet::setScale(ValueScale scale) {
  scale_ = scale;
  setFit(fit_);
}

QStringList CurveSet::withoutPlace(std::span<const VisibleSlices> seen) const {
  QStringList names;
  if (scale_ == ValueScale::kLinear) return names;
  for (const auto& curve : curves_) {
    const bool is_low = std::any_of(seen.begin(), seen.end(), [&](const VisibleSlices& part) {
      return curve->envelope(part.slices, part.pass).lowest() <= 0;
    });
    if (curve->isVisible() && is_low) names << ShortName(curve->path());
  }
  return names;
}

// Returns the extremes of each curve that has values in the slices.
std::vector<CurveSet::Extremes> CurveSet::extremesOn(const UnitAxis& axis,
                                                     std::span<const VisibleSlices> seen) const {
  std::vector<Extremes> all;
  for (const auto& curve : curves_) {
    if (curve->axis() != axis.unit || !curve->isVisible()) continue;
    AxisRange data = kNothing;
    for (const VisibleSlices& part : seen) data = United(data, extremesOf(*curve, part));
    if (data.low <= data.high) all.push_back({curve.get(), data});
  }
  if (scale_ == ValueScale::kLogarithmic) return all;
  double ordinary = 1;
  for (const Extremes& each : all) {
    const double size = SizeOf(each.data, axis.frame.base);
    if (size <= kOrdinary) ordinary = std::max(ordinary, size);
  }
  const auto is_beyond = [&](const Extremes& each) {
    const double size = SizeOf(each.data, axis.frame.base);
    return size > kOrdinary && size > kMaxTimes * ordinary;
  };
  if (std::all_of(all.begin(), all.end(), is_beyond)) return all;
  for (Extremes& each : all) each.is_beyond = is_beyond(each);
  return all;
}

AxisRange CurveSet::extremesOf(const Curve& curve, const VisibleSlices& seen) const {
  const Envelope& envelope = curve.envelope(seen.slices, seen.pass);
  const bool all_have_places = scale_ == ValueScale::kLinear || envelope.lowest() > 0;
  if (all_have_places && seen.first == 0) {
    return {.low = PlaceOf(envelope.lowest(), scale_), .high = PlaceOf(envelope.highest(), scale_)};
  }
  AxisRange data = kNothing;
  for (std::size_t i = seen.first; i < envelope.low().size(); ++i) {
    const double high = envelope.high()[i];
    const double low = envelope.low()[i] > 0 || all_have_places ? envelope.low()[i] : high;
    const bool has_place = low <= high && (all_have_places || low > 0);
    if (!has_place) continue;
    data.low = std::min(data.low, PlaceOf(low, scale_));
    data.high = std::max(data.high, PlaceOf(high, scale_));
  }
  // On a logarithmic axis, a line to a value of 0 or less has no lower limit.
  if (!all_have_places) data.low = std::max(data.low, data.high - kDecadesAboveZero);
  return data;
}

void CurveSet::fitAxes(std::span<const VisibleSlices> seen) {
  beyond_.clear();
  for (UnitAxis& axis : axes_) {
    bool is_whole = false;
    bool is_real = false;
    for (const auto& curve : curves_) {
      if (curve->axis() != axis.unit || curve->samples().empty()) continue;
      (curve->isWhole() ? is_whole : is_real) = true;
    }
    axis.numbers = is_whole && !is_real ? NumberKind::kWhole : NumberKind::kReal;
    if (axis.fitted) fit(axis, seen);
  }
}

// Chooses the frame of the axis. Returns the range of the data as distances from the base of the
// axis; low > high if there is no data.
AxisRange CurveSet::chooseFrame(UnitAxis& axis, std::span<const VisibleSlices> seen) {
  const bool has_base = fit_ != Fit::kSymmetric && !hasStates(axis);
  // Distances are exact only near the base, so a new base gives new distances. These may need
  // another base.
  constexpr int kMaxFrames = 3;
  for (int i = 0;; ++i) {
    const std::vector<Extremes> all = extremesOn(axis, seen);
    AxisRange data = kNothing;
    for (const Extremes& each : all) {
      if (!each.is_beyond) data = United(data, each.data);
    }
    AxisFrame frame = axis.frame;
    if (scale_ == ValueScale::kLogarithmic) {
      frame = {};
    } else if (data.low <= data.high) {
      frame = FrameFor(axis.frame, withGrown(data, axis), axis.numbers);
      if (!has_base) frame.base = 0;
    }
    if (frame != axis.frame && i < kMaxFrames) {
      setFrame(axis, frame);
      continue;
    }
    for (const Extremes& each : all) {
      if (each.is_beyond) beyond_ << ShortName(each.curve->path());
    }
    return data;
  }
}

// If the axis never becomes narrower, extends the range of the data by its previous range. Both
// ranges are distances from the base.
AxisRange CurveSet::withGrown(const AxisRange& data, const UnitAxis& axis) const {
  if (fit_ != Fit::kGrow || !axis.has_grown) return data;
  const double factor = axis.frame.factor();
  return United(data, {.low = axis.grown.low / factor, .high = axis.grown.high / factor});
}

bool CurveSet::hasStates(const UnitAxis& axis) const {
  return axis.names != nullptr && axis.numbers == NumberKind::kWhole &&
         scale_ == ValueScale::kLinear;
}

void CurveSet::fit(UnitAxis& axis, std::span<const VisibleSlices> seen) {
  AxisRange data = chooseFrame(axis, seen);
  if (data.low > data.high) return;
  const bool is_linear = scale_ == ValueScale::kLinear;
  if (is_linear) {
    data = {.low = data.low * axis.frame.factor(), .high = data.high * axis.frame.factor()};
  }
  if (fit_ == Fit::kSymmetric && is_linear) {
    const double most = std::max(std::abs(data.low), std::abs(data.high));
    data = {.low = -most, .high = most};
  }
  if (fit_ == Fit::kGrow && axis.has_grown) data = United(data, axis.grown);
  axis.grown = data;
  axis.has_grown = true;
  if (hasStates(axis)) {
    axis.range = FittedStates(WithAllStates(data, *axis.names));
  } else if (is_linear) {
    axis.range = FittedRange(axis.range, data, axis.numbers, axis.frame.base);
  } else {
    axis.range = FittedDecades(axis.range, data);
  }
}

std::int64_t CurveSet::newestTime() const {
  std::int64_t newest = std::numeric_limits<std::int64_t>::min();
  for (const auto& curve : curves_) {
    const SampleRing& samples = curve->samples();
    if (curve->isRecorded() || samples.empty()) continue;
    newest = std::max(newest, samples.time(samples.endIndex() - 1));
  }
  return newest;
}

std::vector<SourceFigures> CurveSet::figures(std::int64_t now_ns) const {
  std::vector<SourceFigures> figures;
  for (const auto& curve : curves_) {
    if (curve->isRecorded()) continue;
    const QString source = SourceOf(curve->path());
    auto each = std::find_if(figures.begin(), figures.end(),
                             [&](const SourceFigures& there) { return there.source == source; });
    if (each == figures.end()) each = figures.insert(each, SourceFigures{.source = source});
    each->rate = std::max(each->rate, PresentRate(*curve, now_ns));
    if (each->path.isEmpty() || curve->samples().lost() > each->lost) {
      each->path = curve->path();
      each->lost = curve->samples().lost();
      each->losses_before = curve->lossesBefore();
    }
    each->repeated = std::max(each->repeated, curve->samples().repeated());
  }
  return figures;
}

}  // namespace tendon::gui
