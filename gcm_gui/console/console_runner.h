#pragma once

#include <gcm_console/completion/completer.h>
#include <gcm_console/line/settings.h>
#include <gcm_gui/session/courier.h>

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

/// Runs lines in the language of `gcm shell`, in a thread of its own with a link of its own: one
/// after another, while the window goes on. The link is made at the first need.
class ConsoleRunner : public QObject {
  Q_OBJECT

 public:
  explicit ConsoleRunner(console::Settings settings, QObject* parent = nullptr);
  /// Interrupts what runs, and waits for it, though not for ever.
  ~ConsoleRunner() override;

  /// What it writes arrives by output(), its end by finished(). `columns` letters fit into a line.
  void run(const QString& line, int columns);
  [[nodiscard]] bool isRunning() const { return is_running_; }
  /// As Ctrl-C at a terminal; nothing where nothing runs.
  void interrupt();
  /// Asks what a line may go on with; answered by completed() once nothing runs.
  void complete(const QString& line);

 Q_SIGNALS:
  void output(const QString& text, bool is_message);
  void finished(int exit_code);
  /// "robot/arm> ".
  void promptChanged(const QString& prompt);
  /// `line` is what was asked about.
  void completed(const QString& line, const console::Completion& completion);

 private:
  using Job = std::function<void(console::Shell& shell)>;
  struct Desk;
  class End;

  void post(Job job);
  /// Outlives the runner where a request does not end.
  static void work(const std::shared_ptr<Desk>& desk);
  void deliver();
  void finish(int exit_code, const QString& prompt);

  std::shared_ptr<Courier> courier_;
  std::shared_ptr<Desk> desk_;
  QStringDecoder decode_{QStringDecoder::Utf8};
  QString prompt_;
  bool is_running_ = false;
  std::thread thread_;
};

}  // namespace tendon::gui
