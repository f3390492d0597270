#pragma once

#include <gcm_gui/models/facts/row_rate.h>
#include <gcm_gui/models/state_of.h>
#include <gcm_gui/session/signal_source.h>
#include <tendon/base/clock.h>
#include <tendon/manager/description.h>

#include <QAbstractTableModel>
#include <QList>
#include <QSet>
#include <QString>
#include <chrono>
#include <optional>
#include <vector>

namespace tendon::gui {

/// Every number in the state tables of one component, with its newest value, its unit and how it
/// went in the last seconds; the first of a column also with the rate of its rows, or why and how
/// old they are. A column that does not answer says so in its own row.
class ValuesModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kName, kValue, kColumnCount };

  /// Values a trend has; they come 10 times a second.
  static constexpr qsizetype kTrend = 100;
  /// So long a value counts as having just changed.
  static constexpr std::chrono::milliseconds kFresh{500};
  /// After so long without an answer that is said.
  static constexpr std::chrono::seconds kPatience{1};

  explicit ValuesModel(QObject* parent = nullptr, const Clock& clock = SteadyClock())
      : QAbstractTableModel(parent), clock_(clock) {}

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

  /// `path` of the component; null for none. The values come by showValues(); they are old where
  /// the component stands still.
  void show(const QString& path, const ComponentDescription* component, Standstill why);
  /// The paths of its columns: what to watch.
  [[nodiscard]] QSet<QString> columns() const;
  /// Of a row; empty for none.
  [[nodiscard]] QString unit(int row) const;

  /// Whether a row has a number, which can be plotted.
  [[nodiscard]] bool isNumber(int row) const;

  /// From now on answers are awaited; of what has none yet.
  void await();
  /// Until await(), which begins anew, none are.
  void awaitNothing();
  /// The column of a row that has not answered in time, which is awaited anew; else empty.
  [[nodiscard]] QString askAgain(int row);
  /// What has grown old since the last time, a few times a second.
  void tick();

 public Q_SLOTS:
  void showValues(const QString& column, const tendon::gui::ColumnValues& values);
  void showRefusal(const QString& column, const QString& reason);

 private:
  struct Block {  // the rows of one column
    QString column;
    QString name;
    ColumnValues values = {};
    std::vector<QList<std::optional<ChannelValue>>> trends = {};  // of each channel
    std::vector<SteadyTime> changed = {};                         // likewise
    SteadyTime awaited = SteadyTime::max();  // since then, while nothing has come
    QString refusal = {};                    // why nothing has come, where that is known
    SteadyTime arrived = {};                 // its newest row
    RowRate rate = {};
    bool is_out = false;  // while its rows are replaced
    [[nodiscard]] bool isKnown() const { return values.channels != nullptr; }
    [[nodiscard]] int rows() const;
    bool operator==(const Block& other) const { return column == other.column; }
  };
  struct Place {
    const Block* block;
    std::size_t channel;
  };
  [[nodiscard]] Place placeOf(int row) const;
  static void addToTrends(Block& block);
  void noteChanges(Block& block, const ColumnValues& values) const;
  [[nodiscard]] bool isSilent(const Block& block) const;
  [[nodiscard]] bool isOld(const Block& block) const;
  /// Since its newest row was written, or else since it came.
  [[nodiscard]] std::optional<std::chrono::nanoseconds> ageOf(const Block& block) const;
  [[nodiscard]] QString detailOf(const Block& block, std::size_t channel) const;
  /// Why a silent one says so.
  [[nodiscard]] QString silenceOf(const Block& block) const;
  [[nodiscard]] QString spokenOf(const Place& place, const QString& field) const;
  [[nodiscard]] QVariant valueOf(const Place& place, int role) const;
  /// All digits of a value that is shown rounded, else empty.
  [[nodiscard]] static QString wholeOf(const Place& place);
  void replaceRows(Block& block, int first, const ColumnValues& values);

  const Clock& clock_;
  std::vector<Block> blocks_;
  SteadyTime ticked_{};
  Standstill why_ = Standstill::kNone;
};

}  // namespace tendon::gui
