#pragma once

#include <gcm_gui/session/system_reports.h>

#include <QAbstractListModel>
#include <QString>
#include <QStringList>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

namespace tendon::gui {

/// The latest events of the system or of a part of it, newest first. While the model is paused, its
/// rows do not change: new events are stored, and shown after the pause.
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
  /// Shows only the events below this path, such as "robot/arm", and discards the others. An empty
  /// path means all events.
  void setPart(const QString& path);
  /// Shows only events whose path or value contains all these words. A word with a leading `-` must
  /// not occur.
  void setWords(const QStringList& words);
  void setPaused(bool paused);
  [[nodiscard]] bool isPaused() const { return is_paused_; }
  void clear();
  /// Clears the list and forgets what has arrived so far.
  void startOver();

  /// Events per second in the two seconds before `now`, which is in ns since 1970.
  [[nodiscard]] double rate(std::int64_t now) const;
  [[nodiscard]] std::uint64_t lost() const { return lost_; }
  /// The number of events that have arrived since the pause began.
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
  std::deque<EventRecord> all_;     // events of the part, oldest first, shown or not
  std::deque<EventRecord> events_;  // the shown events, newest first
  std::vector<EventRecord> waiting_;
  std::deque<std::int64_t> times_;
  std::uint64_t lost_ = 0;
};

}  // namespace tendon::gui
