#pragma once

#include <gcm_gui/plot/row_losses.h>
#include <gcm_gui/plot/series/sample_ring.h>
#include <gcm_gui/plot/series/value_names.h>
#include <tendon/payload/plot_channel.h>

#include <QObject>
#include <QSet>
#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace tendon::gui {

struct RawPicture;

/// The numbers in a column, in wire order; a new list when their number has changed.
using ChannelList = std::shared_ptr<const std::vector<PlotChannel>>;

/// The newest row of one column, taken apart.
struct ColumnValues {
  ChannelList channels;  ///< never null
  /// Of each channel; nothing where the row has none. Empty before a row.
  std::vector<std::optional<ChannelValue>> values;
  QString text;                                    ///< of a column without numbers, as JSON
  std::shared_ptr<const RawPicture> picture = {};  ///< of a column that holds one, else null
  std::uint64_t rows = 0;                          ///< that have come so far, this one among them
  std::int64_t time = 0;  ///< of this row, ns on this process' steady clock
};

/// Live data of state tables, by path. Two ways to have it: every row of one number (a signal, for
/// plots), or the newest row of a column (for tables, a few times a second). Lives in the GUI
/// thread; nothing here waits.
class SignalSource : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Every row of `signal`, "robot/arm/state.Joints.position[0]", until released as often. What is
  /// not there yet is waited for.
  virtual void subscribe(const QString& signal) = 0;
  virtual void release(const QString& signal) = 0;

  /// From now on `owner` sees the newest values of these columns, "robot/arm/state.Joints", and of
  /// no others. Forgotten when the owner dies.
  virtual void watch(const QObject* owner, const QSet<QString>& columns) = 0;

  /// Of the column that a signal belongs to, since it is subscribed to.
  [[nodiscard]] virtual RowLosses losses(const QString& signal) const = 0;

  /// The process of this column is asked once more, at once.
  virtual void retry(const QString& column) = 0;

 Q_SIGNALS:
  /// In order, none left out that arrived. The samples are valid during the call.
  void samplesArrived(const QString& signal, std::span<const tendon::gui::Sample> samples);
  /// The values of a signal have these names; null where they are numbers. Before its samples, and
  /// once more when its type may have changed.
  void namesLearned(const QString& signal, const tendon::gui::ValueNamesPointer& names);
  /// What follows comes from a new start of the source; its ticks begin anew.
  void epochBegan(const QString& signal);
  /// Nothing arrives for now, and why; empty when its process cannot be reached.
  void wentStale(const QString& signal, const QString& reason);

  void valuesArrived(const QString& column, const tendon::gui::ColumnValues& values);
  /// No values come for now, and why; again and again.
  void valuesRefused(const QString& column, const QString& reason);
};

}  // namespace tendon::gui
