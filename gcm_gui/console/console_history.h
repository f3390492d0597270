#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

namespace tendon::gui {

/// The lines that the user has typed, and a position in this list, which is initially after the
/// newest line. Saved in a file if a name is given. GUI thread; the FileWriter writes the file.
class ConsoleHistory : public QObject {
  Q_OBJECT

 public:
  static constexpr int kKept = 1000;

  /// With an empty file name, nothing is saved.
  explicit ConsoleHistory(const QString& file = {});

  /// Adds a line. Empty lines and repetitions of the newest line are ignored.
  void add(const QString& line);
  /// Moves to the previous line and returns it; at the oldest line, the position does not change.
  /// `typed` is the present text of the input line.
  [[nodiscard]] QString older(const QString& typed);
  /// Moves to the next line and returns it. After the newest line, returns the text that the user
  /// had typed.
  [[nodiscard]] QString newer();
  /// Returns the position of the newest line before position `before` that contains `part`; -1 if
  /// there is none.
  [[nodiscard]] qsizetype find(const QString& part, qsizetype before) const;
  [[nodiscard]] const QStringList& lines() const { return lines_; }

 Q_SIGNALS:
  /// Emitted once, with a sentence for the user, if the lines could not be saved.
  void notice(const QString& text);

 private:
  void keep();

  QString file_;
  QStringList lines_;
  qsizetype place_ = 0;
  QString typed_;
  bool is_refusal_reported_ = false;  // the user knows of the failure; reset by a successful write
};

}  // namespace tendon::gui
