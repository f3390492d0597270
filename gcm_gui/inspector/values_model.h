#pragma once

#include <gcm_gui/models/row_rate.h>
#include <gcm_gui/models/shown_clock.h>
#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/session/signal_source.h>
#include <tendon/base/clock.h>
#include <tendon/manager/component_description.h>

#include <QAbstractTableModel>
#include <QList>
#include <QSet>
#include <QString>
#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

namespace tendon::gui {

/// Every number in the state tables of one component, with its newest value, its unit and its
/// recent trend. The first row of a column also shows the rate at which rows arrive. If the values
/// are old, the first row shows their age and the reason instead. If no reply has come for a
/// column, the rows of this column say so.
class ValuesModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kName, kValue, kColumnCount };

  /// The number of values in a trend. 10 values arrive per second.
  static constexpr qsizetype kTrend = 100;
  /// A value counts as just changed for this time.
  static constexpr std::chrono::milliseconds kFresh{500};
  /// After this time without a reply, the row of the column says so.
  static constexpr std::chrono::seconds kReplyTimeout{1};

  explicit ValuesModel(QObject* parent = nullptr, const Clock& clock = ShownClock())
      : QAbstractTableModel(parent), clock_(clock) {}

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

  /// Shows the component with this path; if `component` is null, shows nothing. The values are
  /// delivered later by showValues(). If the component does not run, `why` says why its values are
  /// old.
  void show(const QString& path, const ComponentDescription* component, StaleReason why);
  /// Returns the paths of the columns to subscribe to.
  [[nodiscard]] QSet<QString> columns() const;
  /// Returns the unit of a row; empty if it has none.
  [[nodiscard]] QString unit(int row) const;

  /// True if the row has a number that can be plotted.
  [[nodiscard]] bool isNumber(int row) const;

  /// Starts the time limit for the columns that have not answered yet.
  void await();
  /// Stops the time limit for these columns until the next await().
  void awaitNothing();
  /// If the row's column has not answered in time, restarts its time limit and returns the path of
  /// the column. Otherwise returns an empty text.
  [[nodiscard]] QString askAgain(int row);
  /// Updates the rows that have become old since the last call. Call it a few times per second.
  void tick();

 public Q_SLOTS:
  void showValues(const QString& column, const tendon::gui::ColumnValues& values);
  void showRefusal(const QString& column, const QString& reason);

 private:
  struct Block {  // the rows of one column
    QString column;
    QString name;
    ColumnValues values = {};
    std::vector<QList<std::optional<NumericValue>>> trends = {};  // by field
    std::vector<SteadyTime> changed = {};                         // by field
    SteadyTime awaited = SteadyTime::max();  // the time when the time limit for the reply began
    QString refusal = {};                    // why no reply came, if known
    SteadyTime arrived = {};                 // arrival time of its newest row
    RowRate rate = {};
    bool is_out = false;  // set while its rows are replaced
    [[nodiscard]] bool isKnown() const { return values.fields != nullptr; }
    [[nodiscard]] int rows() const;
    bool operator==(const Block& other) const { return column == other.column; }
  };
  struct RowPosition {
    const Block* block;
    std::size_t field;
  };
  [[nodiscard]] RowPosition positionOf(int row) const;
  static void addToTrends(Block& block);
  void noteChanges(Block& block, const ColumnValues& values) const;
  [[nodiscard]] bool isSilent(const Block& block) const;
  [[nodiscard]] bool isOld(const Block& block) const;
  /// Returns the time since the newest row was written or, if that is unknown, since it arrived.
  [[nodiscard]] std::optional<std::chrono::nanoseconds> ageOf(const Block& block) const;
  [[nodiscard]] QString detailOf(const Block& block, std::size_t field) const;
  /// Returns the text for a column that has not answered.
  [[nodiscard]] QString silenceOf(const Block& block) const;
  [[nodiscard]] QString spokenOf(const RowPosition& position, const QString& field_path) const;
  [[nodiscard]] QVariant valueOf(const RowPosition& position, int role) const;
  /// Returns all digits of a value that the view shows rounded; otherwise an empty text.
  [[nodiscard]] static QString wholeOf(const RowPosition& position);
  void replaceRows(Block& block, int first, const ColumnValues& values);

  const Clock& clock_;
  std::vector<Block> blocks_;
  SteadyTime ticked_{};
  StaleReason why_ = StaleReason::kNone;
};

}  // namespace tendon::gui
