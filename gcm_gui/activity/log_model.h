#pragma once

#include <tendon/gcm/client.h>

#include <QAbstractListModel>
#include <QString>
#include <cstddef>
#include <cstdint>
#include <deque>

namespace tendon::gui {

/// The newest log records of all processes, in the order of arrival.
class LogModel : public QAbstractListModel {
  Q_OBJECT

 public:
  static constexpr std::size_t kKept = 10000;

  enum Role : int { kLevelRole = Qt::UserRole + 100 };  ///< int: LogLevel

  using QAbstractListModel::QAbstractListModel;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

  [[nodiscard]] const message::LogRecord& record(int row) const {
    return records_.at(static_cast<std::size_t>(row));
  }
  /// The number of records that were lost on their way to this model.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }

 public Q_SLOTS:
  void add(const tendon::LogBatch& batch);
  void clear();

 private:
  std::deque<message::LogRecord> records_;
  std::uint64_t lost_ = 0;
};

/// Returns the path of the record's component ("robot/arm"), or the process ("robot") if the record
/// comes from the process itself.
[[nodiscard]] QString SourceOf(const message::LogRecord& record);

}  // namespace tendon::gui
