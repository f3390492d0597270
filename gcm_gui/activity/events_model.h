#pragma once

#include <gcm_gui/session/system_reports.h>

#include <QAbstractListModel>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <deque>
#include <vector>

namespace tendon::gui {

/// The latest events of a part of the system, newest first. While paused, the rows do not change;
/// new events are counted and shown later.
class EventsModel : public QAbstractListModel {
  Q_OBJECT

 public:
  explicit EventsModel(std::size_t kept, QObject* parent = nullptr)
      : QAbstractListModel(parent), kept_(kept) {}

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

  [[nodiscard]] const EventRecord& eventAt(int row) const {
    return events_.at(static_cast<std::size_t>(row));
  }
  /// Shows only events below this path, "robot/arm", and discards the others; an empty path means
  /// all.
  void setPart(const QString& path);
  /// Shows only events that contain all these words in path or value, and none of the words after
  /// `-`.
  void setWords(const QStringList& words);
  void setPaused(bool paused);
  [[nodiscard]] bool isPaused() const { return is_paused_; }
  void clear();

  /// Events per second in the two seconds before `now`, which is in ns since 1970.
  [[nodiscard]] double rate(std::int64_t now) const;
  [[nodiscard]] std::uint64_t lost() const { return lost_; }
  /// The events since the pause began.
  [[nodiscard]] std::size_t waiting() const { return waiting_.size(); }

 public Q_SLOTS:
  void add(const std::vector<tendon::gui::EventRecord>& events);
  void addLost(const QString& path, std::uint64_t count);

 private:
  [[nodiscard]] bool isOfPart(const QString& path) const;
  [[nodiscard]] bool isShown(const EventRecord& event) const;
  void show(const std::vector<EventRecord>& fresh);

  const std::size_t kept_;
  QString part_;
  QStringList words_;
  bool is_paused_ = false;
  std::deque<EventRecord> all_;     // of the part, oldest first, shown or not
  std::deque<EventRecord> events_;  // the shown ones, newest first
  std::vector<EventRecord> waiting_;
  std::deque<std::int64_t> times_;
  std::uint64_t lost_ = 0;
};

}  // namespace tendon::gui
