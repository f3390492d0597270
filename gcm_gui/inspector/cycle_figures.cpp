#include <gcm_gui/inspector/cycle_figures.h>

#include <gcm_gui/guard/exception_guard.h>

#include <algorithm>
#include <string_view>

namespace tendon::gui {
namespace {

std::optional<double> ValueOf(const ColumnValues& values, std::string_view path) {
  const auto& fields = *values.fields;
  for (std::size_t i = 0; i < std::min(fields.size(), values.values.size()); ++i) {
    const auto& value = values.values[i];
    if (fields[i].path == path && value) return value->real();
  }
  return std::nullopt;
}

}  // namespace

CycleFigures::CycleFigures(SignalSource& source, QObject* parent)
    : QObject(parent), source_(source) {
  connect(&source, &SignalSource::valuesArrived, this, Guarded(this, &CycleFigures::onValues));
}

QString CycleFigures::cycleColumn() const { return component_ + QStringLiteral("/state.Cycle"); }

QString CycleFigures::summaryColumn() const {
  return component_ + QStringLiteral("/state.CycleSummary");
}

void CycleFigures::show(const QString& component) {
  if (component == component_) return;
  component_ = component;
  last_second_.reset();
  skipped_.reset();
  source_.watch(
      this, component_.isEmpty() ? QSet<QString>() : QSet<QString>{cycleColumn(), summaryColumn()});
}

void CycleFigures::onValues(const QString& column, const ColumnValues& values) {
  if (component_.isEmpty()) return;
  if (column == cycleColumn()) {
    if (const auto count = ValueOf(values, ".overruns")) {
      skipped_ = static_cast<std::uint64_t>(*count);
    }
  } else if (column == summaryColumn()) {
    last_second_.reset();
    if (ValueOf(values, ".cycles").value_or(0) == 0) return;
    const auto value = [&](std::string_view path) { return ValueOf(values, path).value_or(0); };
    last_second_ = {value(".period.mean"),  value(".lateness.p50"), value(".lateness.p99"),
                    value(".lateness.max"), value(".compute.mean"), value(".period.max"),
                    value(".compute.max")};
  }
}

}  // namespace tendon::gui
