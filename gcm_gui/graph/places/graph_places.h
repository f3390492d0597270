#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <map>
#include <vector>

namespace tendon::gui {

/// Whether something can stand there; what lies further off is a mistake in a file.
[[nodiscard]] bool IsPlace(const QPointF& place);

/// Where the user has put components in the graph: the left upper corner of each by its path, in
/// the graph's own coordinates. Kept in a file for the next time, also of those that are gone; the
/// last fifty steps can be taken back. GUI thread; the FileWriter writes the file.
class GraphPlaces : public QObject {
  Q_OBJECT

 public:
  using Map = std::map<QString, QPointF>;

  using QObject::QObject;

  /// Takes what the file has, if it can be read, and keeps it there from now on.
  void keepIn(const QString& file);

  [[nodiscard]] const Map& all() const { return all_; }
  [[nodiscard]] bool canUndo() const { return !steps_.empty(); }
  /// The last thing that was done was a move, not something with the system.
  [[nodiscard]] bool isNewest() const { return is_newest_ && canUndo(); }

 public Q_SLOTS:
  /// One step for all of them. With the `key` of the step before, it is a part of that step: many
  /// small moves by keys are taken back at once.
  void move(const std::map<QString, QPointF>& moved, const QString& key = {});
  /// All stand where the layout puts them.
  void reset();
  /// Takes back the last step.
  void undo();
  /// Something else was done since.
  void grow() { is_newest_ = false; }

 Q_SIGNALS:
  void changed();
  /// For the user: the places could not be kept.
  void notice(const QString& text);

 private:
  struct Step {
    QString key;
    Map before;
  };
  void begin(const QString& key);
  void keep();

  QString file_;
  Map all_;
  std::vector<Step> steps_;
  bool is_newest_ = false;
};

}  // namespace tendon::gui
