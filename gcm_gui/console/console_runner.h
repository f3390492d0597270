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

/// Runs lines of the language of `gcm shell`, one after another, in its own thread and over its own
/// link, so the window never waits. The link is opened when first needed.
class ConsoleRunner : public QObject {
  Q_OBJECT

 public:
  explicit ConsoleRunner(console::Settings settings, QObject* parent = nullptr);
  /// Interrupts the running line and waits for it, for a limited time.
  ~ConsoleRunner() override;

  /// Runs a line. output() delivers its output, finished() reports the end. `columns` is the width
  /// of a line in characters.
  void run(const QString& line, int columns);
  [[nodiscard]] bool isRunning() const { return is_running_; }
  /// Like Ctrl-C at a terminal; does nothing if nothing runs.
  void interrupt();
  /// Requests the completions of a line; completed() follows when no line is running.
  void complete(const QString& line);

 Q_SIGNALS:
  void output(const QString& text, bool is_message);
  void finished(int exit_code);
  /// "robot/arm> ".
  void promptChanged(const QString& prompt);
  /// `line` is the line of the request.
  void completed(const QString& line, const console::WordCompletion& completion);

 private:
  using Job = std::function<void(console::Shell& shell)>;
  struct SharedState;
  class LineReport;

  void post(Job job);
  /// The function of the thread, which may outlive the runner if a request does not end.
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
