#pragma once

#include <QFrame>
#include <QString>
#include <QStringList>

class QLabel;
class QLineEdit;
class QToolButton;

namespace tendon::gui {

class GraphView;

/// Finds components in the graph by words that are all in their path or in the names of their
/// interfaces: those stand out, Enter goes from one to the next, Shift+Enter back, Escape ends it.
/// A line over the upper edge of the graph.
class GraphSearch : public QFrame {
  Q_OBJECT

 public:
  explicit GraphSearch(GraphView& graph);

  /// The paths of what fits, sorted.
  [[nodiscard]] const QStringList& found() const { return found_; }
  [[nodiscard]] QLineEdit& field() const { return *field_; }
  /// "2 of 14".
  [[nodiscard]] QString told() const;
  /// Ends the search, if there is one; false where there is none.
  bool leave();

 public Q_SLOTS:
  /// With what was looked for the last time, to be typed over.
  void open();
  void next() { go(1); }
  void previous() { go(-1); }

 Q_SIGNALS:
  /// Of what was found, this is to be seen.
  void chosen(const QString& path);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void search();
  void go(int way);
  void tell();
  void moveToEdge();
  QToolButton* addButton(const QString& text, const QString& name, const QString& help);

  GraphView& graph_;
  QLineEdit* field_;
  QLabel* count_;
  QStringList found_;
  qsizetype current_ = -1;  // of what was found; -1 before the first
};

}  // namespace tendon::gui
