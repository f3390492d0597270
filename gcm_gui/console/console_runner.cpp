#include <gcm_gui/console/console_runner.h>

#include <gcm_console/completion/completer.h>
#include <gcm_console/shell/shell.h>
#include <gcm_gui/console/output_pipe.h>
#include <gcm_gui/files/file_writer.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <program/exit_code.h>
#include <tendon/base/os/termination.h>

#include <condition_variable>
#include <deque>
#include <iostream>
#include <mutex>
#include <optional>
#include <utility>

namespace tendon::gui {
namespace {

constexpr auto kThread = QT_TRANSLATE_NOOP("Words", "the console");

}  // namespace

/// The data shared by the runner and its thread.
struct ConsoleRunner::SharedState {
  SharedState(console::Settings the_settings, std::function<void()> wake)
      : settings(std::move(the_settings)), pipe(std::move(wake)) {}

  const console::Settings settings;
  OutputPipe pipe;
  std::mutex mutex;
  std::condition_variable change;
  std::deque<Job> jobs;                      // guarded by mutex, as are all members below
  os::Interruption* interruption = nullptr;  // interrupts the thread; null after it has ended
  bool is_interrupted = false;               // interrupted since the last job was added
  bool is_ending = false;
  bool is_done = false;  // the thread has ended
};

/// Reports the end of a line in every case, even if the thread throws an exception or the line is
/// never executed.
class ConsoleRunner::LineReport {
 public:
  LineReport(ConsoleRunner& runner, std::shared_ptr<GuiPoster> poster)
      : runner_(runner), poster_(std::move(poster)) {}
  LineReport(const LineReport&) = delete;
  LineReport& operator=(const LineReport&) = delete;
  ~LineReport() {
    ExceptionGuard::run(kThread, [&] {
      poster_->post(
          [runner = &runner_, code = exit_code, text = prompt] { runner->finish(code, text); });
    });
  }

  int exit_code = program::kRefused;
  QString prompt = QStringLiteral("gcm> ");

 private:
  ConsoleRunner& runner_;
  std::shared_ptr<GuiPoster> poster_;
};

ConsoleRunner::ConsoleRunner(console::Settings settings, QObject* parent)
    : QObject(parent),
      poster_(std::make_shared<GuiPoster>(this)),
      desk_(std::make_shared<SharedState>(
          std::move(settings), [this, poster = poster_] { poster->post([this] { deliver(); }); })) {
}

ConsoleRunner::~ConsoleRunner() {
  poster_->detach();
  desk_->pipe.close();
  if (!thread_.joinable()) return;
  std::unique_lock lock(desk_->mutex);
  desk_->is_ending = true;
  if (desk_->interruption != nullptr) desk_->interruption->Request();
  desk_->change.notify_all();
  const bool is_done =
      desk_->change.wait_for(lock, FileWriter::kTimeout, [this] { return desk_->is_done; });
  lock.unlock();
  if (is_done) {
    thread_.join();
    return;
  }
  std::cerr << "gcm-gui: a command of the console does not end; the window closes without waiting "
               "for this command\n";
  thread_.detach();
}

void ConsoleRunner::post(Job job) {
  const std::scoped_lock lock(desk_->mutex);
  // Ignores an interruption that was meant for the previous line.
  if (desk_->interruption != nullptr) desk_->interruption->Forget();
  desk_->is_interrupted = false;
  desk_->jobs.push_back(std::move(job));
  desk_->change.notify_all();
  if (!thread_.joinable()) thread_ = std::thread([desk = desk_] { work(desk); });
}

void ConsoleRunner::work(const std::shared_ptr<SharedState>& desk) {
  os::HoldTerminationSignals();
  os::Interruption interruption;
  std::optional<console::Shell> shell;
  std::unique_lock lock(desk->mutex);
  while (true) {
    desk->interruption = &interruption;
    desk->change.wait(lock, [&] { return !desk->jobs.empty() || desk->is_ending; });
    if (desk->is_ending) break;
    Job job = std::exchange(desk->jobs.front(), nullptr);
    desk->jobs.pop_front();
    // Repeats an interruption that the user requested before `interruption` existed.
    if (desk->is_interrupted) interruption.Request();
    lock.unlock();
    ExceptionGuard::run(kThread, [&] {
      if (!shell || shell->has_ended()) shell.emplace(desk->settings);
      job(*shell);
    });
    job = nullptr;
    lock.lock();
  }
  desk->interruption = nullptr;
  lock.unlock();
  shell.reset();  // without the lock, because closing the link takes some time
  lock.lock();
  desk->is_done = true;
  desk->change.notify_all();
}

void ConsoleRunner::run(const QString& line, int columns) {
  if (std::exchange(is_running_, true)) return;
  // The job must not own the shared state, because the shared state owns the job.
  auto end = std::make_shared<LineReport>(*this, poster_);
  post([end = std::move(end), &pipe = desk_->pipe, line = line.toStdString(),
        columns](console::Shell& shell) {
    PipeStream out(pipe, OutputPipe::Kind::kOut);
    PipeStream err(pipe, OutputPipe::Kind::kError);
    const console::Streams streams{out, err, columns, nullptr, false};
    try {
      end->exit_code = shell.Run(line, streams, AfterError::kGoOn);
    } catch (...) {
      err << "gcm: " << CurrentExceptionText().toStdString() << '\n';
    }
    if (!shell.has_ended()) end->prompt = ToQString(shell.prompt());
  });
}

void ConsoleRunner::interrupt() {
  if (!is_running_) return;
  const std::scoped_lock lock(desk_->mutex);
  desk_->is_interrupted = true;
  if (desk_->interruption != nullptr) desk_->interruption->Request();
}

void ConsoleRunner::complete(const QString& line) {
  if (is_running_) return;
  post([this, poster = poster_, line](console::Shell& shell) {
    const auto unfinished = console::ParsePartialCommand(line.toStdString());
    console::WordCompletion completion = shell.Complete(unfinished);
    console::AddFiles(completion, unfinished.words.back());
    poster->post([this, line, completion] { Q_EMIT completed(line, completion); });
  });
}

void ConsoleRunner::deliver() {
  for (const OutputPipe::Piece& piece : desk_->pipe.take()) {
    const QString text = decode_(QByteArrayView(piece.text.data(), qsizetype(piece.text.size())));
    if (!text.isEmpty()) Q_EMIT output(text, piece.kind == OutputPipe::Kind::kError);
  }
}

/// Reports the end of the line after all its output has been delivered.
void ConsoleRunner::finish(int exit_code, const QString& prompt) {
  if (!desk_->pipe.isEmpty()) {
    return poster_->post([this, exit_code, prompt] { finish(exit_code, prompt); });
  }
  is_running_ = false;
  if (prompt != std::exchange(prompt_, prompt)) Q_EMIT promptChanged(prompt);
  Q_EMIT finished(exit_code);
}

}  // namespace tendon::gui
