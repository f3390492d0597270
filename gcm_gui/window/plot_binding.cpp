#include <gcm_gui/window/plot_binding.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/catalogue_model.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/shown_clock.h>
#include <gcm_gui/plot/plot_panel.h>

#include <algorithm>
#include <chrono>

namespace tendon::gui {

PlotBinding::PlotBinding(PlotPanel& panel, SignalSource& source, SignalSource& recordings,
                         const CatalogueModel& model, QObject* parent)
    : QObject(parent), panel_(panel), source_(source), recordings_(recordings), model_(model) {
  connect(&panel, &PlotPanel::subscriptionWanted, this,
          [this](const QString& path) { sourceOf(path).subscribe(path); });
  connect(&panel, &PlotPanel::subscriptionReleased, this,
          [this](const QString& path) { sourceOf(path).release(path); });
  connectSource(source);
  connectSource(recordings);
  connect(&source, &SignalSource::beganAgain, this, Guarded(this, &PlotBinding::beginAgain));
  panel.setLosses([this](const QString& path) { return sourceOf(path).losses(path); });
  panel.setStandstills([this](const QString& path, std::optional<std::int64_t> newest_ns) {
    return standstillOf(path, newest_ns);
  });
  panel.setCandidates([this](const QString& path) { return candidatesFor(path); });
}

void PlotBinding::connectSource(SignalSource& source) {
  connect(&source, &SignalSource::namesLearned, &panel_, Guarded(&panel_, &PlotPanel::setNames));
  connect(&source, &SignalSource::samplesArrived, &panel_, Guarded(&panel_, &PlotPanel::append));
  connect(&source, &SignalSource::epochBegan, &panel_, Guarded(&panel_, &PlotPanel::beginEpoch));
  connect(&source, &SignalSource::wentStale, this, Guarded(this, &PlotBinding::showStale));
}

void PlotBinding::beginAgain() { panel_.removeSamples(); }

SignalSource& PlotBinding::sourceOf(const QString& path) const {
  return RecordingOf(path).isEmpty() ? source_ : recordings_;
}

void PlotBinding::showStale(const QString& path, const QString& reason) {
  if (!RecordingOf(path).isEmpty()) return panel_.setStale(path, reason);
  const CatalogueItem* process = model_.item(model_.indexOf(path.section('/', 0, 0)));
  // If the process is lost, gives no reason. The loss is reported elsewhere, and the legend shows
  // the rows for which the curve waits.
  const bool gone = process == nullptr || process->gone;
  panel_.setStale(path, gone ? QString() : reason);
}

QString PlotBinding::standstillOf(const QString& path,
                                  std::optional<std::int64_t> newest_ns) const {
  const StaleReason why = model_.standstill(path);
  if (why == StaleReason::kNone) return {};
  std::optional<std::chrono::nanoseconds> age;
  if (newest_ns) {
    const std::chrono::nanoseconds now = ShownClock().Now().time_since_epoch();
    age = std::max(std::chrono::nanoseconds(0), now - std::chrono::nanoseconds(*newest_ns));
  }
  return IsStale(why, age, 0) ? OldText(why, age) : QString();
}

// Returns the numbers that may replace a signal. Paths with the longest common end come first: if a
// component was renamed, the rest of the path, with its table, is the same.
QList<CurveKey> PlotBinding::candidatesFor(const QString& path) const {
  QList<CurveKey> all;
  for (int row = 0; row < model_.rowCount({}); ++row) {
    all += model_.signalsBelow(model_.index(row, 0, {}).data(kPathRole).toString());
  }
  const QString tail = path.section('.', 1);
  std::stable_partition(all.begin(), all.end(),
                        [&](const CurveKey& key) { return key.path.section('.', 1) == tail; });
  return all;
}

void PlotBinding::plot(const QString& path) {
  const QList<CurveKey> keys = model_.signalsBelow(path);
  const CatalogueItem* item = model_.item(model_.indexOf(path));
  if (item == nullptr) return;
  if (item->kind < ItemKind::kColumn || keys.isEmpty()) {
    Q_EMIT notice(path + Words::tr(" cannot be plotted, because it is not a number; select a "
                                   "column or a value of a state table"));
    return;
  }
  for (const CurveKey& key : keys.mid(0, kMaxAtOnce)) panel_.addSignal(key.path, key.unit);
  if (keys.size() > kMaxAtOnce) {
    Q_EMIT notice(Words::tr("The first %1 of %2 numbers are plotted; select fewer numbers")
                      .arg(kMaxAtOnce)
                      .arg(keys.size()));
  }
}

void PlotBinding::plotSignal(const QString& path, const QString& unit) {
  panel_.addSignal(path, unit);
}

}  // namespace tendon::gui
