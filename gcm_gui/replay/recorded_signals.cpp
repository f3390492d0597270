#include <gcm_gui/replay/recorded_signals.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/series/shown_time.h>
#include <gcm_gui/plot/series/signal_path.h>
#include <gcm_gui/plot/series/time_shift.h>
#include <gcm_gui/replay/replay_signals.h>

#include <QFileInfo>
#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

namespace tendon::gui {
namespace {

constexpr std::chrono::milliseconds kFollowPeriod{33};
constexpr std::int64_t kLongestRead = 3'600'000'000'000;  // ns, of the visible time
constexpr std::int64_t kMaxMargin = 60'000'000'000;       // ns, before and after the visible time

}  // namespace

/// One open recording. Its times are in ns since 1970, except the times of samples.
class RecordedSignals::File : public QObject {
 public:
  File(RecordedSignals& owner, QString path)
      : owner_(owner),
        path_(std::move(path)),
        reader_(ReplayReader::Content::kRows, owner.open_file_) {
    connect(&reader_, &ReplayReader::opened, this, &File::onOpened);
    connect(&reader_, &ReplayReader::refused, this, &File::fail);
    connect(&reader_, &ReplayReader::stepped, this, &File::onStep);
    connect(&signals_, &ReplaySignals::pastWanted, this, [this] { is_past_wanted_ = true; });
    connect(&signals_, &ReplaySignals::beganAgain, &owner,
            [this] { Q_EMIT owner_.readAgain(path_); });
    connect(&signals_, &SignalSource::samplesArrived, this, &File::passOn);
    connect(&signals_, &SignalSource::namesLearned, &owner,
            [this](const QString& signal, const ValueNamesPointer& names) {
              Q_EMIT owner_.namesLearned(RecordedPath(path_, signal), names);
            });
    connect(&signals_, &SignalSource::epochBegan, &owner, [this](const QString& signal) {
      Q_EMIT owner_.epochBegan(RecordedPath(path_, signal));
    });
    connect(&signals_, &SignalSource::wentStale, &owner,
            [this](const QString& signal, const QString& reason) { tell(signal, reason); });
    reader_.open(path_);
  }

  void subscribe(const QString& signal) {
    signals_.subscribe(signal);
    tell(signal, failure_.isEmpty() ? Words::tr("is being read") : failure_);
  }
  void release(const QString& signal) { signals_.release(signal); }
  [[nodiscard]] bool isUnused() const { return signals_.subscribed().isEmpty(); }

  void follow(std::optional<TimeSpan> seen) {
    if (is_busy_ || !seen || !failure_.isEmpty()) return;
    const std::int64_t seen_end = MovedTime(seen->to_ns, WallOffset());
    const std::int64_t to = std::min(seen_end, facts_.last);
    const std::int64_t from =
        std::max({MovedTime(seen->from_ns, WallOffset()), to - kLongestRead, facts_.first});
    if (from > to) return beOutOfSight();
    const bool has_begin = read_ && read_->from_ns <= from && from <= read_->to_ns;
    if (!is_past_wanted_ && has_begin && to <= read_->to_ns) return;
    const std::int64_t margin = std::min((to - from) / 2, kMaxMargin);
    const std::int64_t end = std::min(MovedTime(to, margin), facts_.last);
    is_busy_ = true;
    if (!is_past_wanted_ && has_begin) {
      read_->to_ns = end;
      return reader_.play(end);
    }
    is_past_wanted_ = false;
    const std::int64_t begin = std::max(from - margin, facts_.first);
    read_ = {.from_ns = begin, .to_ns = end};
    reader_.jump(end, end - begin, signals_.beginJump());
  }

 private:
  void onOpened(const RecordingFacts& facts) {
    facts_ = facts;
    is_busy_ = false;
    const std::int64_t back_ns = -WallOffset();
    Q_EMIT owner_.opened(path_, {.from_ns = MovedTime(facts.first, back_ns),
                                 .to_ns = MovedTime(facts.last, back_ns)});
    tellProblems(facts.problems);
  }

  void onStep(const ReplayStep& step) {
    is_busy_ = false;
    if (step.is_jump) signals_.endJump();
    signals_.deliver();
    tellProblems(step.problems);
    if (step.is_gone)
      fail(Words::tr(
          "the file does not exist any more; the data that was already read is still shown"));
  }

  // No part of the recording is visible, so nothing is read.
  void beOutOfSight() {
    if (std::exchange(is_past_wanted_, false)) {
      read_.reset();
      Q_EMIT owner_.readAgain(path_);
    }
  }

  void fail(const QString& reason) {
    is_busy_ = false;
    failure_ = reason;
    for (const QString& signal : signals_.subscribed()) tell(signal, reason);
    Q_EMIT owner_.notice(QFileInfo(path_).fileName() + QStringLiteral(": ") + reason);
  }

  void tellProblems(const QStringList& problems) {
    if (problems.size() == known_problems_) return;
    known_problems_ = problems.size();
    Q_EMIT owner_.notice(Words::tr("%1 is damaged, and shown as far as it can be read: %2")
                             .arg(QFileInfo(path_).fileName(), problems.back()));
  }

  void tell(const QString& signal, const QString& reason) {
    Q_EMIT owner_.wentStale(RecordedPath(path_, signal), reason);
  }

  void passOn(const QString& signal, std::span<const Sample> samples) {
    // Converts a time of the window that shows the recording to the time of the plots.
    const std::int64_t by_ns = MovedTime(-ReplayReader::SampleTime(0, facts_.first), -WallOffset());
    std::vector<Sample> moved(samples.begin(), samples.end());
    for (Sample& sample : moved) sample.time_ns = MovedTime(sample.time_ns, by_ns);
    Q_EMIT owner_.samplesArrived(RecordedPath(path_, signal), moved);
  }

  RecordedSignals& owner_;
  const QString path_;
  ReplayReader reader_;
  ReplaySignals signals_;
  RecordingFacts facts_;
  std::optional<TimeSpan> read_;
  qsizetype known_problems_ = 0;
  QString failure_;
  bool is_busy_ = true;  // until the file is open, and while it is read
  bool is_past_wanted_ = false;
};

RecordedSignals::RecordedSignals(Seen seen, ReplayReader::OpenFile open_file)
    : seen_(std::move(seen)), open_file_(std::move(open_file)) {
  connect(&timer_, &QTimer::timeout, this, &RecordedSignals::follow);
}

RecordedSignals::~RecordedSignals() = default;

void RecordedSignals::subscribe(const QString& signal) {
  const QString path = RecordingOf(signal);
  if (path.isEmpty()) return;
  std::unique_ptr<File>& file = files_[path];
  if (file == nullptr) file = std::make_unique<File>(*this, path);
  file->subscribe(SignalOf(signal));
  timer_.start(kFollowPeriod);
}

void RecordedSignals::release(const QString& signal) {
  const auto file = files_.find(RecordingOf(signal));
  if (file != files_.end()) file->second->release(SignalOf(signal));
}

void RecordedSignals::follow() {
  std::erase_if(files_, [](const auto& each) { return each.second->isUnused(); });
  if (files_.empty()) timer_.stop();
  for (const auto& [path, file] : files_) file->follow(seen_(path));
}

}  // namespace tendon::gui
