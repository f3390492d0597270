#include <gcm_gui/inspector/cycle_figures.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tendon::gui {

CycleFigures::CycleFigures(SignalSource& source, QObject* parent)
    : QObject(parent), source_(source) {
  connect(&source, &SignalSource::valuesArrived, this, &CycleFigures::hearValues);
  connect(&source, &SignalSource::samplesArrived, this, &CycleFigures::hearSamples);
}

QString CycleFigures::column() const { return component_ + QStringLiteral("/state.Cycle"); }

QString CycleFigures::latenessSignal() const { return column() + QStringLiteral(".lateness"); }

void CycleFigures::show(const QString& component) {
  if (component == component_) return;
  if (!component_.isEmpty()) source_.release(latenessSignal());
  component_ = component;
  period_.reset();
  compute_ = 0;
  overruns_ = 0;
  lateness_.clear();
  if (component_.isEmpty()) {
    source_.watch(this, {});
  } else {
    source_.subscribe(latenessSignal());
    source_.watch(this, {column()});
  }
  Q_EMIT changed();
}

void CycleFigures::hearValues(const QString& column, const ColumnValues& values) {
  if (component_.isEmpty() || column != this->column()) return;
  const auto& channels = *values.channels;
  for (std::size_t i = 0; i < std::min(channels.size(), values.values.size()); ++i) {
    const double value = values.values[i];
    if (channels[i].path == ".period") period_ = value;
    if (channels[i].path == ".compute") compute_ = value;
    if (channels[i].path == ".overruns") overruns_ = static_cast<std::uint64_t>(value);
  }
  Q_EMIT changed();
}

void CycleFigures::hearSamples(const QString& signal, std::span<const Sample> samples) {
  if (component_.isEmpty() || signal != latenessSignal()) return;
  for (const Sample& sample : samples) lateness_.push_back(sample.value);
  while (lateness_.size() > kRows) lateness_.pop_front();
}

std::optional<double> CycleFigures::lateness(double part) const {
  if (lateness_.empty()) return std::nullopt;
  std::vector<double> sorted(lateness_.begin(), lateness_.end());
  const auto rank =
      static_cast<std::ptrdiff_t>(std::lround(part * static_cast<double>(sorted.size() - 1)));
  std::nth_element(sorted.begin(), sorted.begin() + rank, sorted.end());
  return sorted[static_cast<std::size_t>(rank)];
}

}  // namespace tendon::gui
