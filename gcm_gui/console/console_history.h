#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

namespace tendon::gui {

/// The typed lines and a position among them, initially after the newest. Saved in a file, if one
/// is given. GUI thread; the FileWriter writes the file.
class ConsoleHistory : public QObject {
  Q_OBJECT

 public:
  static constexpr int kKept = 1000;

  /// With an empty file name, nothing is saved.
  explicit ConsoleHistory(const QString& file = {});

  /// Ignores empty lines and a repetition of the newest line.
  void add(const QString& line);
  /// The previous line; stays at the oldest. `typed` is the present text of the input line.
  [[nodiscard]] QString older(const QString& typed);
  /// The next line; after the newest, the text that was typed.
  [[nodiscard]] QString newer();
  /// The newest line that contains `part`, below position `before`; -1 if there is none.
  [[nodiscard]] qsizetype find(const QString& part, qsizetype before) const;
  [[nodiscard]] const QStringList& lines() const { return lines_; }

 Q_SIGNALS:
  /// Tells the user, once, that the lines could not be saved.
  void notice(const QString& text);

 private:
  void keep();

  QString file_;
  QStringList lines_;
  qsizetype place_ = 0;
  QString typed_;
  bool is_refusal_told_ = false;  // the failure was reported; false again after a successful write
};

}  // namespace tendon::gui
