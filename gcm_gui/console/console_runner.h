#pragma once

#include <gcm_console/completion/completer.h>
#include <gcm_console/line/settings.h>
#include <gcm_gui/console/output_pipe.h>
#include <gcm_gui/session/courier.h>

#include <QObject>
#include <QString>
#include <QStringDecoder>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

namespace console {
class Shell;
}
namespace tendon::os {
class Interruption;
}

namespace tendon::gui {

/// Runs lines in the language of `gcm shell`, in a thread of its own with a link of its own: one
/// after another, while the window goes on. The link is made at the first need.
class ConsoleRunner : public QObject {
  Q_OBJECT

 public:
  explicit ConsoleRunner(console::Settings settings, QObject* parent = nullptr);
  /// Interrupts what runs, and waits for it: at most as long as a request may take.
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

  void post(Job job);
  void work();
  void deliver();
  void finish(int exit_code, const QString& prompt);

  const console::Settings settings_;
  std::shared_ptr<Courier> courier_;
  OutputPipe pipe_;
  QStringDecoder decode_{QStringDecoder::Utf8};
  QString prompt_;
  bool is_running_ = false;

  std::mutex mutex_;
  std::condition_variable change_;
  std::deque<Job> jobs_;
  os::Interruption* interruption_ = nullptr;  // of the thread, while it lives
  bool is_interrupted_ = false;               // since the last job was posted
  bool is_ending_ = false;
  std::thread thread_;
};

}  // namespace tendon::gui
