#include <gcm_gui/recording/recording_worker.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <tendon/recording/save_last.h>

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <system_error>
#include <utility>

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;
using SteadyPoint = std::chrono::steady_clock::time_point;

constexpr std::chrono::milliseconds kReportPeriod{250};
constexpr std::chrono::seconds kRateSpan{5};  // a file grows in steps of whole chunks
constexpr int kMaxNames = 100;

/// The growth of a file over the last seconds.
class GrowthRate {
 public:
  /// Bytes per second.
  double add(SteadyPoint now, std::uint64_t bytes) {
    points_.emplace_back(now, bytes);
    while (points_.size() > 2 && now - points_[1].first >= kRateSpan) points_.pop_front();
    const std::chrono::duration<double> span = now - points_.front().first;
    const std::uint64_t grown = bytes - std::min(bytes, points_.front().second);
    return span.count() > 0 ? static_cast<double>(grown) / span.count() : 0.0;
  }

 private:
  std::deque<std::pair<SteadyPoint, std::uint64_t>> points_;
};

}  // namespace

/// One recording, shared by its thread and the worker.
///
/// It has its own GcmClient and does not share the window's. A recorder requests the log and whole
/// catalogues, and the window's listener would receive them, too. Rows of a shared client pass
/// through one thread, so a recording of everything would delay the plots. In addition, the file
/// must be completed while the window and its session end.
class RecordingWorker::Run {
 public:
  Run(std::shared_ptr<Middleware> middleware, GcmClient::Options options, RecordingRequest request,
      std::shared_ptr<GuiPoster> poster, RecordingWorker& worker)
      : middleware_(std::move(middleware)),
        options_(std::move(options)),
        request_(std::move(request)),
        poster_(std::move(poster)),
        worker_(worker) {}

  /// The thread of the recording.
  void record() {
    QString failure;
    try {
      failure = recordUntilStopped();
    } catch (...) {
      failure = CurrentExceptionText();
    }
    end(failure);  // done only now, after the client was destroyed, because its destructor may wait
                   // for the network
    const std::lock_guard lock(mutex_);
    is_done_ = true;
    changed_.notify_all();
  }

  void requestStop() {
    const std::lock_guard lock(mutex_);
    is_stop_requested_ = true;
    changed_.notify_all();
  }
  /// True if the thread has nothing left to do.
  bool waitForEnd(std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, timeout, [this] { return is_done_; });
  }
  /// Empty if there is none yet.
  QString file() {
    const std::lock_guard lock(mutex_);
    return file_;
  }

 private:
  bool waitForStop(std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, timeout, [this] { return is_stop_requested_; });
  }

  template <typename... Args, typename... Values>
  void report(void (RecordingRunner::*signal)(Args...), const Values&... values) {
    // The worker is used only in its own thread, and only while it exists.
    poster_->post([&worker = worker_, signal, values...] { (worker.*signal)(values...); });
  }

  /// Returns the reason if the file is not complete, or if there is none.
  QString recordUntilStopped() {
    const auto queue = std::make_shared<recording::RecordingQueue>();
    GcmClient client(middleware_, options_, queue);
    if (const auto watching = client.WaitUntilWatching(); !watching) {
      return ToQString(watching.error().message);
    }
    if (waitForStop(0ms)) return {};
    if (request_.past.count() > 0) return savePast(client, queue);
    auto recorder = makeRecorder(client, queue);
    if (!recorder) return ToQString(recorder.error().message);
    begin(ToQString((*recorder)->status().file.string()));
    bool has_failed = false;
    while (!has_failed && !waitForStop(kReportPeriod)) {
      has_failed = measure(**recorder).status.failure.has_value();
      report(&RecordingRunner::progressed, last_);
      reportInterruptions(**recorder);
    }
    const auto stopped = (*recorder)->Stop();
    measure(**recorder);
    reportInterruptions(**recorder);
    return stopped ? QString() : ToQString(stopped.error().message);
  }

  Result<std::unique_ptr<recording::Recorder>> makeRecorder(
      GcmClient& client, const std::shared_ptr<recording::RecordingQueue>& queue) {
    recording::RecorderOptions options{.patterns = request_.patterns, .timeout = options_.timeout};
    return withFreeName<std::unique_ptr<recording::Recorder>>(
        [&](const std::filesystem::path& file) {
          options.files.file = file;
          return recording::Recorder::Start(client, queue, options);
        });
  }

  QString savePast(GcmClient& client, const std::shared_ptr<recording::RecordingQueue>& queue) {
    const auto start = std::chrono::steady_clock::now();
    recording::GcmSystem system(client, options_.timeout);
    const auto saved =
        withFreeName<recording::SaveLastReport>([&](const std::filesystem::path& file) {
          return recording::SaveLast(system, queue,
                                     {.patterns = request_.patterns,
                                      .files = {.file = file},
                                      .last = request_.past,
                                      .timeout = options_.timeout});
        });
    if (!saved) return ToQString(saved.error().message);
    begin(ToQString(saved->file.string()));
    last_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    last_.status.counts = saved->counts;
    last_.status.losses = saved->losses;
    for (const std::string& one : recording::ShortfallsOf(*saved, request_.past)) {
      last_.shortfalls << ToQString(one);
    }
    return {};
  }

  /// Calls `make(file)` with one name after another until a name is not in use.
  template <typename T, typename Make>
  Result<T> withFreeName(Make make) {
    const std::filesystem::path folder = request_.folder.toStdString();
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) {
      return Error{ErrorCode::kFailed, Words::tr("the folder %1 cannot be created: %2")
                                           .arg(request_.folder, ToQString(failed.message()))
                                           .toStdString()};
    }
    for (int number = 1;; ++number) {
      const std::string ending = number == 1 ? "" : "-" + std::to_string(number);
      Result<T> made = make(folder / (request_.name.toStdString() + ending + ".mcap"));
      const bool is_taken = !made && made.error().code == ErrorCode::kExists;
      if (!is_taken || number == kMaxNames) return made;
    }
  }

  const RecordingProgress& measure(const recording::Recorder& recorder) {
    const auto now = std::chrono::steady_clock::now();
    last_.status = recorder.status();
    last_.seconds = std::chrono::duration<double>(now - begin_).count();
    last_.rate = rate_.add(now, last_.status.counts.bytes);
    return last_;
  }

  void reportInterruptions(recording::Recorder& recorder) {
    for (const std::string& sentence : recorder.TakeNotices()) {
      report(&RecordingRunner::interrupted, ToQString(sentence));
    }
  }

  void begin(const QString& file) {
    {
      const std::lock_guard lock(mutex_);
      file_ = file;
    }
    begin_ = std::chrono::steady_clock::now();
    report(&RecordingRunner::begun, file);
  }

  void end(const QString& failure) {
    if (file().isEmpty()) return report(&RecordingRunner::refused, failure);
    report(&RecordingRunner::ended, last_, failure);
  }

  const std::shared_ptr<Middleware> middleware_;
  const GcmClient::Options options_;
  const RecordingRequest request_;
  const std::shared_ptr<GuiPoster> poster_;
  RecordingWorker& worker_;

  // Of the thread.
  SteadyPoint begin_;
  GrowthRate rate_;
  RecordingProgress last_;

  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_stop_requested_ = false;
  bool is_done_ = false;
  QString file_;
};

RecordingWorker::RecordingWorker(std::shared_ptr<Middleware> middleware, GcmClient::Options options)
    : middleware_(std::move(middleware)),
      options_(std::move(options)),
      poster_(std::make_shared<GuiPoster>(this)) {}

RecordingWorker::~RecordingWorker() {
  poster_->detach();
  complete();
}

void RecordingWorker::start(const RecordingRequest& request) {
  if (thread_.joinable())
    thread_.join();  // the thread has reported its end, which is its last action
  run_ = std::make_shared<Run>(middleware_, options_, request, poster_, *this);
  thread_ = std::thread([run = run_] { run->record(); });
}

void RecordingWorker::stop() {
  if (run_) run_->requestStop();
}

void RecordingWorker::complete(std::chrono::milliseconds timeout) {
  if (!thread_.joinable()) return;
  run_->requestStop();
  if (run_->waitForEnd(timeout)) return thread_.join();
  std::cerr << "gcm-gui: the recording " << run_->file().toStdString()
            << " is not complete: the rest could not be written to the disk within "
            << timeout.count() << " ms\n";
  thread_.detach();
}

}  // namespace tendon::gui
