#include <gcm_console/completion/files.h>
#include <gcm_console/shell/shell.h>
#include <gcm_gui/console/console_runner.h>
#include <gcm_gui/models/text.h>
#include <tendon/base/os/termination.h>

#include <optional>
#include <utility>

namespace tendon::gui {

ConsoleRunner::ConsoleRunner(console::Settings settings, QObject* parent)
    : QObject(parent),
      settings_(std::move(settings)),
      courier_(std::make_shared<Courier>(this)),
      pipe_([this, courier = courier_] { courier->post([this] { deliver(); }); }) {}

ConsoleRunner::~ConsoleRunner() {
  courier_->detach();
  pipe_.close();
  {
    const std::scoped_lock lock(mutex_);
    is_ending_ = true;
    if (interruption_ != nullptr) interruption_->Ask();
    change_.notify_all();
  }
  if (thread_.joinable()) thread_.join();
}

void ConsoleRunner::post(Job job) {
  const std::scoped_lock lock(mutex_);
  if (interruption_ != nullptr) interruption_->Forget();  // it was for what ran before
  is_interrupted_ = false;
  jobs_.push_back(std::move(job));
  change_.notify_all();
  if (!thread_.joinable()) thread_ = std::thread([this] { work(); });
}

void ConsoleRunner::work() {
  os::HoldTerminationSignals();
  os::Interruption interruption;
  std::optional<console::Shell> shell;
  while (true) {
    std::unique_lock lock(mutex_);
    interruption_ = &interruption;
    change_.wait(lock, [this] { return !jobs_.empty() || is_ending_; });
    if (is_ending_) {
      interruption_ = nullptr;
      return;
    }
    const Job job = std::exchange(jobs_.front(), nullptr);
    jobs_.pop_front();
    if (is_interrupted_) interruption.Ask();  // also where nobody was there to hear it
    lock.unlock();
    if (!shell || shell->has_ended()) shell.emplace(settings_);
    job(*shell);
  }
}

void ConsoleRunner::run(const QString& line, int columns) {
  if (std::exchange(is_running_, true)) return;
  post([this, courier = courier_, line = line.toStdString(), columns](console::Shell& shell) {
    PipeStream out(pipe_, OutputPipe::Kind::kOut);
    PipeStream err(pipe_, OutputPipe::Kind::kError);
    const console::Streams streams{out, err, columns, nullptr, false};
    const int exit_code = shell.Run(line, streams, console::Shell::AfterFailure::kGoOn);
    const QString prompt = shell.has_ended() ? QStringLiteral("gcm> ") : ToQString(shell.prompt());
    courier->post([this, exit_code, prompt] { finish(exit_code, prompt); });
  });
}

void ConsoleRunner::interrupt() {
  if (!is_running_) return;
  const std::scoped_lock lock(mutex_);
  is_interrupted_ = true;
  if (interruption_ != nullptr) interruption_->Ask();
}

void ConsoleRunner::complete(const QString& line) {
  if (is_running_) return;
  post([this, courier = courier_, line](console::Shell& shell) {
    const auto unfinished = console::UnfinishedOf(line.toStdString());
    console::Completion completion = shell.Complete(unfinished);
    console::AddFiles(completion, unfinished.words.back());
    courier->post([this, line, completion] { Q_EMIT completed(line, completion); });
  });
}

void ConsoleRunner::deliver() {
  for (const OutputPipe::Piece& piece : pipe_.take()) {
    const QString text = decode_(QByteArrayView(piece.text.data(), qsizetype(piece.text.size())));
    if (!text.isEmpty()) Q_EMIT output(text, piece.kind == OutputPipe::Kind::kError);
  }
}

/// Behind all that it wrote: pieces of it may be on their way still.
void ConsoleRunner::finish(int exit_code, const QString& prompt) {
  if (!pipe_.isEmpty()) {
    return courier_->post([this, exit_code, prompt] { finish(exit_code, prompt); });
  }
  is_running_ = false;
  if (prompt != std::exchange(prompt_, prompt)) Q_EMIT promptChanged(prompt);
  Q_EMIT finished(exit_code);
}

}  // namespace tendon::gui
