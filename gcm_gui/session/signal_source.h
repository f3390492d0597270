#pragma once

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

/// The numbers in a column, in wire order; a new list if their number changes.
using NumericFieldList = std::shared_ptr<const std::vector<NumericField>>;

/// The newest row of one column, decoded.
struct ColumnValues {
  NumericFieldList fields;  ///< never null
  /// By field; no value if the row does not have it. Empty before the first row.
  std::vector<std::optional<NumericValue>> values;
  QString text;                                  ///< of a column without numbers, as JSON
  std::shared_ptr<const RawImage> picture = {};  ///< of a column with a picture; otherwise null
  std::uint64_t rows = 0;                        ///< the number of rows so far, this one included
  std::int64_t time = 0;                         ///< of this row, ns on this process's steady clock
};

/// Live data of state tables, by path, in two ways: every row of one number (a signal, for plots),
/// or the newest row of a column a few times a second (for tables). GUI thread; no function waits.
class SignalSource : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Delivers every row of `signal`, "robot/arm/state.Joints.position[0]", until release() is
  /// called as often. Waits for a signal that does not exist yet.
  virtual void subscribe(const QString& signal) = 0;
  virtual void release(const QString& signal) = 0;

  /// Sets the columns, "robot/arm/state.Joints", whose newest values `owner` needs; replaces
  /// earlier ones. Ends when `owner` is destroyed.
  virtual void watch(const QObject* owner, const QSet<QString>& columns) = 0;

  /// The losses of the signal's column since its subscription.
  [[nodiscard]] virtual RowLosses losses(const QString& signal) const = 0;

  /// Asks the process of this column again, at once.
  virtual void retry(const QString& column) = 0;

 Q_SIGNALS:
  /// New samples, in order and complete. They are valid only during the call.
  void samplesArrived(const QString& signal, std::span<const tendon::gui::Sample> samples);
  /// The names of a signal's values; null for plain numbers. Emitted before its samples, and again
  /// when its type may have changed.
  void namesLearned(const QString& signal, const tendon::gui::ValueNamesPointer& names);
  /// The source was restarted: its ticks start again with the following samples.
  void epochBegan(const QString& signal);
  /// No samples arrive for now. `reason` says why; it is empty if the process is unreachable.
  void wentStale(const QString& signal, const QString& reason);

  void valuesArrived(const QString& column, const tendon::gui::ColumnValues& values);
  /// No values arrive for now; emitted repeatedly during this time.
  void valuesRefused(const QString& column, const QString& reason);
};

}  // namespace tendon::gui
