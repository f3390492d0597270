#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <map>
#include <vector>

namespace tendon::gui {

/// Returns false for a very distant position, because this is a mistake in a file.
[[nodiscard]] bool IsPlausiblePosition(const QPointF& position);

/// The positions that the user has given to components: the top left corners by path, in scene
/// coordinates. They are saved in a file, even for components that no longer exist. The last fifty
/// steps can be undone. GUI thread; the FileWriter writes the file.
class NodePositions : public QObject {
  Q_OBJECT

 public:
  using Map = std::map<QString, QPointF>;

  using QObject::QObject;

  /// Loads the positions from the file if it can be read. From now on, saves changes to it.
  void keepIn(const QString& file);

  [[nodiscard]] const Map& all() const { return all_; }
  [[nodiscard]] bool canUndo() const { return !steps_.empty(); }
  /// Returns true if the last action of the user moved a component, and no action on the system
  /// followed.
  [[nodiscard]] bool isNewest() const { return is_newest_ && canUndo(); }

 public Q_SLOTS:
  /// Moves several components in one step. If `key` is the same as in the previous step, the move
  /// becomes a part of that step. In this way, many small moves by keys are undone together.
  void move(const std::map<QString, QPointF>& moved, const QString& key = {});
  /// Returns all components to their automatic positions.
  void reset();
  /// Undoes the last step.
  void undo();
  /// Called when the user has done something other than moving components.
  void onOtherAction() { is_newest_ = false; }

 Q_SIGNALS:
  void changed();
  /// Emitted with a sentence for the user if the positions could not be saved.
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
