#pragma once

#include <gcm_gui/plot/series/row_losses.h>
#include <gcm_gui/plot/series/sample_ring.h>
#include <gcm_gui/plot/series/value_names.h>
#include <tendon/payload/numeric_field.h>

#include <QObject>
#include <QSet>
#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace tendon::gui {

struct RawImage;

/// The numbers in a column, in the order of the wire format. When the fields of the column change,
/// a new list is made; an existing list never changes.
using NumericFieldList = std::shared_ptr<const std::vector<NumericField>>;

/// The newest row of one column, decoded.
struct ColumnValues {
  NumericFieldList fields;  ///< never null
  /// One value for each field. An entry is nullopt if the row does not have the field. The vector
  /// is empty before the first row.
  std::vector<std::optional<NumericValue>> values;
  QString text;                                  ///< JSON; only for a column without numbers
  std::shared_ptr<const RawImage> picture = {};  ///< null if the column has no picture
  std::uint64_t rows = 0;                        ///< number of rows so far, including this one
  std::int64_t time = 0;  ///< time of this row, in ns on this process's steady clock
};

/// Live data of state tables, requested by path. There are two ways: subscribe() delivers every row
/// of one number (a signal, for plots), watch() delivers the newest row of a column a few times a
/// second (for tables). GUI thread; no function blocks.
class SignalSource : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Delivers every row of `signal`, such as "robot/arm/state.Joints.position[0]". Ends when
  /// release() has been called as often as subscribe(). The signal need not exist yet.
  virtual void subscribe(const QString& signal) = 0;
  virtual void release(const QString& signal) = 0;

  /// Sets the columns, such as "robot/arm/state.Joints", whose newest values `owner` needs. They
  /// replace the earlier columns of `owner`. Ends when `owner` is destroyed.
  virtual void watch(const QObject* owner, const QSet<QString>& columns) = 0;

  /// Returns the losses of the signal's column since its subscription.
  [[nodiscard]] virtual RowLosses losses(const QString& signal) const = 0;

  /// Repeats the request to the process of this column at once.
  virtual void retry(const QString& column) = 0;

 Q_SIGNALS:
  /// Emitted when another moment of a recording is shown. All samples are outdated; the samples up
  /// to that moment follow.
  void beganAgain();
  /// Emitted with new samples, in order and complete. They are valid only during the call.
  void samplesArrived(const QString& signal, std::span<const tendon::gui::Sample> samples);
  /// Emitted with the names of a signal's values; null if they are plain numbers. Emitted before
  /// the first samples, and again when the type of the signal may have changed.
  void namesLearned(const QString& signal, const tendon::gui::ValueNamesPointer& names);
  /// Emitted when the source was restarted: its ticks start again with the following samples.
  void epochBegan(const QString& signal);
  /// Emitted when no more samples arrive for now. `reason` says why. An empty reason means that the
  /// process is unreachable.
  void wentStale(const QString& signal, const QString& reason);

  void valuesArrived(const QString& column, const tendon::gui::ColumnValues& values);
  /// Emitted repeatedly while no values arrive. `reason` says why.
  void valuesRefused(const QString& column, const QString& reason);
};

}  // namespace tendon::gui
