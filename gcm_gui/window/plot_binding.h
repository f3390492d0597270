#pragma once

#include <gcm_gui/plot/series/signal_path.h>
#include <gcm_gui/session/signal_source.h>

#include <QObject>
#include <QString>
#include <cstdint>
#include <optional>

namespace tendon::gui {

class CatalogueModel;
class PlotPanel;

/// Subscribes to the rows that the plots request, of the shown system and of recordings, and passes
/// them to the plots.
class PlotBinding : public QObject {
  Q_OBJECT

 public:
  /// The maximum number of curves that are added to a plot at once.
  static constexpr int kMaxAtOnce = 16;

  PlotBinding(PlotPanel& panel, SignalSource& source, SignalSource& recordings,
              const CatalogueModel& model, QObject* parent = nullptr);

 public Q_SLOTS:
  /// Plots all numbers at and below a path of the catalogue.
  void plot(const QString& path);
  void plotSignal(const QString& path, const QString& unit);

 Q_SIGNALS:
  /// Emitted with one sentence if nothing, or not everything, could be plotted.
  void notice(const QString& text);

 private:
  void connectSource(SignalSource& source);
  void beginAgain();
  [[nodiscard]] SignalSource& sourceOf(const QString& path) const;
  [[nodiscard]] QList<CurveKey> candidatesFor(const QString& path) const;
  void showStale(const QString& path, const QString& reason);
  [[nodiscard]] QString standstillOf(const QString& path,
                                     std::optional<std::int64_t> newest_ns) const;

  PlotPanel& panel_;
  SignalSource& source_;
  SignalSource& recordings_;
  const CatalogueModel& model_;
};

}  // namespace tendon::gui
