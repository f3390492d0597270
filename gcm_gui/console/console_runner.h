#pragma once

#include <gcm_console/command_line/settings.h>
#include <gcm_console/completion/completer.h>
#include <gcm_gui/files/gui_poster.h>

#include <QObject>
#include <QString>
#include <QStringDecoder>
#include <functional>
#include <memory>
#include <thread>

namespace console {
class Shell;
}
namespace tendon::gui {

/// Runs command lines of `gcm shell`, one after another, in a separate thread and over a separate
/// link, so that the window never blocks. Opens the link when it is first needed.
class ConsoleRunner : public QObject {
  Q_OBJECT

 public:
  explicit ConsoleRunner(console::Settings settings, QObject* parent = nullptr);
  /// Interrupts the running line and waits for it, for a limited time.
  ~ConsoleRunner() override;

  /// Runs a line. Its output is delivered by output(); finished() is emitted at its end. `columns`
  /// is the width of the console in characters.
  void run(const QString& line, int columns);
  [[nodiscard]] bool isRunning() const { return is_running_; }
  /// Interrupts the running line, as Ctrl-C does in a terminal; does nothing if no line is running.
  void interrupt();
  /// Requests the completions of a line. completed() is emitted when no line is running any more.
  void complete(const QString& line);

 Q_SIGNALS:
  void output(const QString& text, bool is_message);
  void finished(int exit_code);
  /// Emitted with the new prompt, such as "robot/arm> ".
  void promptChanged(const QString& prompt);
  /// Emitted with the reply to complete(); `line` is the line that was passed to it.
  void completed(const QString& line, const console::WordCompletion& completion);

 private:
  using Job = std::function<void(console::Shell& shell)>;
  struct SharedState;
  class LineReport;

  void post(Job job);
  /// The main function of the thread. The thread may outlive the runner if a request does not end.
  static void work(const std::shared_ptr<SharedState>& desk);
  void deliver();
  void finish(int exit_code, const QString& prompt);

  std::shared_ptr<GuiPoster> poster_;
  std::shared_ptr<SharedState> desk_;
  QStringDecoder decode_{QStringDecoder::Utf8};
  QString prompt_;
  bool is_running_ = false;
  std::thread thread_;
};

}  // namespace tendon::gui
