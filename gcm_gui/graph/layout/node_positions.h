#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <map>
#include <vector>

namespace tendon::gui {

/// False for a very distant position, which is a mistake in a file.
[[nodiscard]] bool IsPlausiblePosition(const QPointF& position);

/// The positions that the user has given to components: the top left corner by path, in scene
/// coordinates. Saved in a file, even for components that are gone; the last fifty steps can be
/// undone. GUI thread; the FileWriter writes the file.
class NodePositions : public QObject {
  Q_OBJECT

 public:
  using Map = std::map<QString, QPointF>;

  using QObject::QObject;

  /// Loads the file if it can be read, and saves to it from now on.
  void keepIn(const QString& file);

  [[nodiscard]] const Map& all() const { return all_; }
  [[nodiscard]] bool canUndo() const { return !steps_.empty(); }
  /// True if the user's last action was a move here and not an action on the system.
  [[nodiscard]] bool isNewest() const { return is_newest_ && canUndo(); }

 public Q_SLOTS:
  /// Moves all of them in one step. The same `key` as in the previous step extends that step, so
  /// that many small moves by keys are undone together.
  void move(const std::map<QString, QPointF>& moved, const QString& key = {});
  /// Returns all components to their automatic positions.
  void reset();
  /// Undoes the last step.
  void undo();
  /// Called when the user has done something else.
  void onOtherAction() { is_newest_ = false; }

 Q_SIGNALS:
  void changed();
  /// Tells the user that the positions could not be saved.
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
