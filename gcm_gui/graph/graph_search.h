#pragma once

#include <QFrame>
#include <QString>
#include <QStringList>

class QLabel;
class QLineEdit;
class QToolButton;

namespace tendon::gui {

class GraphView;

/// A search field over the upper edge of the graph. It highlights the components for which the path
/// or an interface name contains all the words. Enter goes to the next match, Shift+Enter to the
/// previous one, Escape ends the search.
class GraphSearch : public QFrame {
  Q_OBJECT

 public:
  explicit GraphSearch(GraphView& graph);

  /// The paths of the matches, sorted.
  [[nodiscard]] const QStringList& found() const { return found_; }
  [[nodiscard]] QLineEdit& field() const { return *field_; }
  /// Ends the search; returns false if no search was open.
  bool leave();

 public Q_SLOTS:
  /// Opens the field with the last words selected, so that typing overwrites them.
  void open();
  void next() { go(1); }
  void previous() { go(-1); }

 Q_SIGNALS:
  /// Emitted when the user has moved to this match.
  void chosen(const QString& path);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void search();
  void go(int way);
  void showCount();
  void moveToEdge();
  QToolButton* addButton(const QString& text, const QString& name, const QString& help);

  GraphView& graph_;
  QLineEdit* field_;
  QLabel* count_;
  QStringList found_;
  qsizetype current_ = -1;  // index into found_; -1 before the first
};

}  // namespace tendon::gui
