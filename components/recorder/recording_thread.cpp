#include <components/recorder/recording_thread.h>

#include <tendon/payload/numeric_value.h>
#include <tendon/recording/save_last.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <future>
#include <utility>

namespace recorder {
namespace {

using tendon::recording::RecorderStatus;
using namespace std::chrono_literals;

constexpr double kLongestPast = 24.0 * 3600;  // s

/// "20251121-154003"
std::string TimeOfNow() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm local{};
  localtime_r(&now, &local);
  char text[32] = {};
  return {text, std::strftime(text, sizeof text, "%Y%m%d-%H%M%S", &local)};
}

}  // namespace

RecordingThread::RecordingThread(std::shared_ptr<tendon::LocalAccess> process,
                                 RecorderConfiguration settings)
    : process_(std::move(process)), settings_(std::move(settings)) {}

RecordingThread::~RecordingThread() { Finish(); }

void RecordingThread::Start() {
  worker_.Post([this] { StartNow(); });
}

void RecordingThread::Stop() {
  worker_.Post([this] {
    if (!recorder_ && !is_starting_) {
      return Report(RecordingOutcome::Kind::kFailed, "there is no recording to stop");
    }
    StopNow();
  });
}

void RecordingThread::SaveLast(double seconds) {
  worker_.Post([this, seconds] { SaveLastNow(seconds); });
}

void RecordingThread::Finish() {
  const auto ended = std::make_shared<std::promise<void>>();
  worker_.Post([this, ended] {
    if (recorder_ || is_starting_) StopNow();
    ended->set_value();
  });
  ended->get_future().wait();
}

RecorderState RecordingThread::state() const {
  const std::scoped_lock lock(mutex_);
  return state_;
}

std::vector<RecordingOutcome> RecordingThread::TakeOutcomes() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(outcomes_, {});
}

void RecordingThread::StartNow() {
  if (is_starting_)
    return Report(RecordingOutcome::Kind::kFailed, "a recording is already being started");
  if (recorder_) {
    return Report(RecordingOutcome::Kind::kFailed, "a recording is already running and writes " +
                                                       recorder_->status().file.string() +
                                                       "; stop that recording first");
  }
  is_starting_ = true;
  ++starts_;
  options_ = NextRecording();
  tries_ = 0;
  Begin();
}

void RecordingThread::Begin() {
  if (!is_starting_) return;  // it was stopped
  const auto queue = std::make_shared<tendon::recording::RecordingQueue>();
  system_ = std::make_shared<tendon::recording::LocalSystem>(process_, queue);
  const bool has_condition = options_.start_when || options_.stop_when;
  const auto unknown = has_condition ? system_->WhyUnknown() : std::nullopt;
  SetWaiting(unknown.has_value());
  if (unknown) {  // the paths of the conditions must be known
    system_.reset();
    constexpr int kTriesUntilTold = 10;
    if (++tries_ == kTriesUntilTold) {
      Report(RecordingOutcome::Kind::kDelayed,
             "the recording has not begun yet: " + unknown->message);
    }
    return worker_.PostAfter(100ms, [this, start = starts_] {
      if (start == starts_) Begin();
    });
  }
  is_starting_ = false;
  auto started = tendon::recording::Recorder::Start(system_, queue, std::move(options_));
  if (!started) {
    system_.reset();
    return Report(RecordingOutcome::Kind::kFailed, started.error().message);
  }
  recorder_ = *std::move(started);
  ++recordings_;
  bytes_ = 0;
  next_rate_ = tendon::SteadyClock().Now() + 1s;
  is_waiting_ = true;  // Look() tells the start
  Look();
}

void RecordingThread::StopNow() {
  if (std::exchange(is_starting_, false)) {
    SetWaiting(false);
    return Report(RecordingOutcome::Kind::kStopped, "");
  }
  const auto stopped = recorder_->Stop();
  const RecorderStatus status = recorder_->status();
  {
    const std::scoped_lock lock(mutex_);
    state_.is_recording = false;
    state_.is_waiting = false;
    state_.rows = status.counts.rows;
    state_.events = status.counts.events;
    state_.commands = status.counts.commands;
    state_.bytes = status.counts.bytes;
    state_.rate = 0.0;
    state_.disk_left = status.disk_free;
    state_.lost = status.losses.all();
  }
  recorder_.reset();
  system_.reset();
  if (!stopped) return Report(RecordingOutcome::Kind::kFailed, stopped.error().message);
  if (is_waiting_ && !status.is_waiting)
    Report(RecordingOutcome::Kind::kStarted, status.file.string());
  Report(RecordingOutcome::Kind::kStopped, status.is_waiting ? "" : status.file.string());
}

void RecordingThread::SaveLastNow(double seconds) {
  if (!(seconds > 0.0 && seconds <= kLongestPast)) {
    return Report(RecordingOutcome::Kind::kFailed,
                  "cannot save the last " + ToString(tendon::NumericValue(seconds)) +
                      " s: expected more than 0 and at most 86400 s");
  }
  const auto queue = std::make_shared<tendon::recording::RecordingQueue>();
  tendon::recording::LocalSystem system(process_, queue);
  tendon::recording::SaveLastOptions options{
      .patterns = settings_.patterns, .files = NextFile(), .has_log = settings_.log};
  options.files.split_size = 0;
  options.files.split_time = {};
  options.last =
      std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(seconds));
  const std::chrono::nanoseconds last = options.last;
  const auto saved = tendon::recording::SaveLast(system, queue, std::move(options));
  if (!saved) return Report(RecordingOutcome::Kind::kFailed, saved.error().message);
  for (const auto& text : tendon::recording::ShortfallsOf(*saved, last)) {
    Report(RecordingOutcome::Kind::kFailed, text);
  }
  Report(RecordingOutcome::Kind::kSaved, saved->file.string());
}

/// Ten times a second while there is a recording.
void RecordingThread::Look() {
  if (!recorder_) return;
  const RecorderStatus status = recorder_->status();
  if (is_waiting_ && !status.is_waiting) {
    is_waiting_ = false;
    Report(RecordingOutcome::Kind::kStarted, status.file.string());
  }
  if (status.failure || status.is_finished) return StopNow();
  const tendon::SteadyTime now = tendon::SteadyClock().Now();
  {
    const std::scoped_lock lock(mutex_);
    state_ = {.is_recording = !status.is_waiting,
              .is_waiting = status.is_waiting,
              .rows = status.counts.rows,
              .events = status.counts.events,
              .commands = status.counts.commands,
              .bytes = status.counts.bytes,
              .rate = state_.is_recording ? state_.rate : 0.0,
              .disk_left = status.disk_free,
              .lost = status.losses.all()};
    if (now >= next_rate_) {
      const std::chrono::duration<double> passed = now - next_rate_ + 1s;
      const auto more = status.counts.bytes - std::min(bytes_, status.counts.bytes);
      state_.rate = static_cast<double>(more) / passed.count();
      bytes_ = status.counts.bytes;
      next_rate_ = now + 1s;
    }
  }
  worker_.PostAfter(100ms, [this, recording = recordings_] {
    if (recording == recordings_) Look();
  });
}

void RecordingThread::SetWaiting(bool is_waiting) {
  const std::scoped_lock lock(mutex_);
  state_.is_waiting = is_waiting;
}

void RecordingThread::Report(RecordingOutcome::Kind kind, std::string text) {
  const std::scoped_lock lock(mutex_);
  outcomes_.push_back({kind, std::move(text)});
}

tendon::recording::RecorderOptions RecordingThread::NextRecording() const {
  tendon::recording::RecorderOptions options{
      .patterns = settings_.patterns, .files = NextFile(), .has_log = settings_.log};
  const auto time_of = [](double seconds) {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
        std::chrono::duration<double>(seconds));
  };
  // The component has checked that both can be read.
  if (!settings_.start_when.empty()) {
    options.start_when = *tendon::recording::ParseCondition(settings_.start_when);
  }
  if (!settings_.stop_when.empty()) {
    options.stop_when = *tendon::recording::ParseCondition(settings_.stop_when);
  }
  options.before = time_of(settings_.before);
  options.after = time_of(settings_.after);
  return options;
}

/// Two recordings may begin within a second.
tendon::recording::FileOptions RecordingThread::NextFile() const {
  const std::string name = settings_.name + "-" + TimeOfNow();
  const std::filesystem::path folder(settings_.folder);
  tendon::recording::FileOptions options{.file = folder / (name + ".mcap"),
                                         .compression = settings_.compression,
                                         .split_size = settings_.split_size,
                                         .keep = settings_.keep};
  options.split_time = std::chrono::duration_cast<std::chrono::nanoseconds>(
      std::chrono::duration<double>(settings_.split_time));
  // A saved file has no number, even if recordings are split.
  std::error_code ignored;
  const auto is_used = [&] {
    return std::filesystem::exists(options.file, ignored) ||
           std::filesystem::exists(tendon::recording::FileName(options, 1), ignored);
  };
  for (int number = 2; is_used(); ++number) {
    options.file = folder / (name + "_" + std::to_string(number) + ".mcap");
  }
  return options;
}

}  // namespace recorder
