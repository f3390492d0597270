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

UnitAxis* AxisFor(std::vector<UnitAxis>& axes, const QString& unit) {
  const auto found = std::find_if(axes.begin(), axes.end(),
                                  [&](const UnitAxis& axis) { return axis.unit == unit; });
  return found == axes.end() ? nullptr : &*found;
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
  curves_.push_back(std::make_unique<Curve>(key, freeColor()));
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
  curve->setColorIndex(freeColor());
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
      continue;
    }
    const UnitAxis* there = AxisFor(axes_, name);
    axes.push_back(there != nullptr ? *there : UnitAxis{.unit = name});
    axes.back().color_index = curve->colorIndex();
  }
  axes_ = std::move(axes);
}

// The first colour no curve has; with more curves than colours they begin anew.
int CurveSet::freeColor() const {
  int color = 0;
  const auto taken = [&](const auto& curve) { return curve->colorIndex() == color; };
  while (std::any_of(curves_.begin(), curves_.end(), taken)) ++color;
  return color;
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

QStringList CurveSet::withoutPlace(std::span<const SeenSlices> seen) const {
  QStringList names;
  if (scale_ == ValueScale::kLinear) return names;
  for (const auto& curve : curves_) {
    const bool is_low = std::any_of(seen.begin(), seen.end(), [&](const SeenSlices& part) {
      return curve->envelope(part.slices, part.pass).lowest() <= 0;
    });
    if (curve->isVisible() && is_low) names << ShortName(curve->path());
  }
  return names;
}

// In places. low > high when there is nothing.
AxisRange CurveSet::extremesOf(const UnitAxis& axis, std::span<const SeenSlices> seen) const {
  AxisRange data = kNothing;
  for (const auto& curve : curves_) {
    if (curve->axis() != axis.unit || !curve->isVisible()) continue;
    for (const SeenSlices& part : seen) {
      const AxisRange extremes = extremesOf(*curve, part);
      data.low = std::min(data.low, extremes.low);
      data.high = std::max(data.high, extremes.high);
    }
  }
  return data;
}

AxisRange CurveSet::extremesOf(const Curve& curve, const SeenSlices& seen) const {
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
  // A line on its way to 0 and below comes as near to it as one likes.
  if (!all_have_places) data.low = std::max(data.low, data.high - kDecadesAboveZero);
  return data;
}

void CurveSet::fitAxes(std::span<const SeenSlices> seen) {
  for (UnitAxis& axis : axes_) {
    if (!axis.fitted) continue;
    AxisRange data = extremesOf(axis, seen);
    if (data.low > data.high) continue;
    if (fit_ == Fit::kSymmetric && scale_ == ValueScale::kLinear) {
      const double most = std::max(std::abs(data.low), std::abs(data.high));
      data = {.low = -most, .high = most};
    }
    if (fit_ == Fit::kGrow && axis.has_grown) {
      data = {.low = std::min(data.low, axis.grown.low),
              .high = std::max(data.high, axis.grown.high)};
    }
    axis.grown = data;
    axis.has_grown = true;
    axis.range = FittedRange(axis.range, data);
  }
}

std::int64_t CurveSet::newestTime() const {
  std::int64_t newest = std::numeric_limits<std::int64_t>::min();
  for (const auto& curve : curves_) {
    const SampleRing& samples = curve->samples();
    if (!samples.empty()) newest = std::max(newest, samples.time(samples.endIndex() - 1));
  }
  return newest;
}

std::vector<SourceFigures> CurveSet::figures(std::int64_t now_ns) const {
  std::vector<SourceFigures> figures;
  for (const auto& curve : curves_) {
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
