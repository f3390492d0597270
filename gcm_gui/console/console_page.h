#pragma once

#include <gcm_gui/console/console_history.h>
#include <gcm_gui/console/console_runner.h>

#include <QString>
#include <QWidget>
#include <optional>

class QKeyEvent;
class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace tendon::gui {

/// The console in the window, with the output above and the input line below. The keys are as in a
/// shell: Up and Down browse the history, Ctrl-R searches it, Tab completes, Ctrl-C interrupts or
/// copies, Ctrl-L clears the output.
class ConsolePage : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kKeptLines = 5000;

  /// `history` is the file for the typed lines; if it is empty, they are not saved.
  explicit ConsolePage(console::Settings settings, const QString& history = {},
                       QWidget* parent = nullptr);

  void focusLine();
  [[nodiscard]] QString text() const;
  [[nodiscard]] bool isRunning() const { return runner_.isRunning(); }

 Q_SIGNALS:
  /// Emitted with a sentence for the user if the typed lines could not be saved.
  void notice(const QString& text);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Search {
    QString part;
    QString typed;  // the line before the search
    qsizetype place = -1;
  };

  void build();
  void applyFont();
  /// Returns true if the input line must handle the key, even if a shortcut of the window has the
  /// same key.
  [[nodiscard]] static bool isTyping(const QKeyEvent& key);
  bool pressKey(const QKeyEvent& event);
  bool pressControl(int key);
  bool pressInSearch(const QKeyEvent& event);
  void submit();
  void copyOrInterrupt();
  void complete();
  void showCompletion(const QString& line, const console::WordCompletion& completion);
  void searchFrom(qsizetype before);
  void leaveSearch();
  void showPrompt();
  /// The number of characters that fit into a line.
  [[nodiscard]] int columns() const;
  void write(const QString& text, bool is_message);

  ConsoleRunner runner_;
  ConsoleHistory history_;
  QString prompt_ = QStringLiteral("gcm> ");
  std::optional<Search> search_;

  QPlainTextEdit* output_ = nullptr;
  QLabel* prompt_label_ = nullptr;
  QLineEdit* line_ = nullptr;
};

}  // namespace tendon::gui
