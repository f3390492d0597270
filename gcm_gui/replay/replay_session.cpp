#include <gcm_gui/replay/replay_session.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/plot/series/shown_time.h>

#include <QFileInfo>
#include <algorithm>
#include <chrono>
#include <utility>

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;

constexpr auto kFrame = 33ms;
constexpr qint64 kValuesPeriod = 100;                     // ms
constexpr std::int64_t kShortestPast = 5'000'000'000;     // ns
constexpr std::int64_t kLongestPast = 3'600'000'000'000;  // ns
constexpr std::int64_t kMaxLate = 500'000'000;            // ns of the recording, at speed 1
constexpr std::int64_t kSameMark = 1'000'000;             // ns

}  // namespace

ReplaySession::ReplaySession(const QString& file, ReplayReader::OpenFile open_file)
    : file_(QFileInfo(file).absoluteFilePath()),
      open_file_(std::move(open_file)),
      reason_(ReplayRefusal(file)),
      reports_(reason_),
      refusals_(reason_, store_),
      recordings_(reason_) {
  link_.setFile(fileName());
  now_.start();
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &ReplaySession::advance);
  soon_.setSingleShot(true);
  connect(&soon_, &QTimer::timeout, this, &ReplaySession::advance);
  connect(&signals_, &ReplaySignals::pastWanted, this, [this] {
    if (state_ != State::kOpen) return;
    if (!wanted_) wanted_ = position_;
    soon_.start(0ms);
  });
  connect(&signals_, &ReplaySignals::columnWanted, this,
          [this](const std::string& path, const std::shared_ptr<ColumnFeed>& feed) {
            if (state_ != State::kOpen) return;  // the first jump will have it
            ++pending_;
            reader_->add(path, feed);
          });
  connect(&refusals_, &ReplayRefusals::notice, this, &ReplaySession::notice);
  reload();
}

ReplaySession::~ReplaySession() {
  reader_.reset();
  ShowPresent();
}

QString ReplaySession::fileName() const { return QFileInfo(file_).fileName(); }

void ReplaySession::reload() {
  if (state_ == State::kOpen) reopened_at_ = position_;
  state_ = State::kOpening;
  timer_.stop();
  pending_ = 0;
  finds_awaited_ = 0;
  is_jumping_ = false;
  wanted_.reset();
  reader_ = std::make_unique<ReplayReader>(ReplayReader::Content::kAll, open_file_);
  connect(reader_.get(), &ReplayReader::opened, this, &ReplaySession::onOpened);
  connect(reader_.get(), &ReplayReader::refused, this, &ReplaySession::onRefused);
  connect(reader_.get(), &ReplayReader::stepped, this, &ReplaySession::onStep);
  connect(reader_.get(), &ReplayReader::found, this, &ReplaySession::onFound);
  reader_->open(file_);
  Q_EMIT changed();
}

void ReplaySession::onOpened(const RecordingFacts& facts) {
  facts_ = facts;
  state_ = State::kOpen;
  const double speed = clock_.speed();
  const bool is_looping = clock_.isLooping();
  clock_ = PlaybackClock(facts.first, facts.last);
  clock_.setSpeed(speed, now_.nsecsElapsed());
  clock_.setLooping(is_looping);
  refusals_.setTypes(facts.types);
  timer_.start(kFrame);
  seek(reopened_at_.value_or(facts.first));
  Q_EMIT changed();
}

void ReplaySession::onRefused(const QString& sentence) {
  state_ = State::kRefused;
  refusal_ = sentence;
  is_jumping_ = false;
  if (link_.state() == LinkState::State::kSearching) link_.setUnreachable(sentence);
  Q_EMIT changed();
}

void ReplaySession::seek(std::int64_t time) {
  if (state_ != State::kOpen) return;
  clock_.seek(time, now_.nsecsElapsed());
  wanted_ = clock_.position(now_.nsecsElapsed());
  is_find_overtaken_ = finds_awaited_ > 0;
  advance();
}

std::int64_t ReplaySession::past() const {
  return std::clamp(past_wanted_ ? past_wanted_() : kShortestPast, kShortestPast, kLongestPast);
}

void ReplaySession::followPast() {
  if (state_ != State::kOpen || isJumping() || read_from_ <= facts_.first) return;
  if (position_ - past() >= read_from_ || past_read_ >= kLongestPast) return;
  wanted_ = position_;
  advance();
}

void ReplaySession::advance() {
  if (state_ != State::kOpen || pending_ > 0) return;
  if (wanted_) return startJump();
  const qint64 now = now_.nsecsElapsed();
  const PlaybackClock::Turn turn = clock_.update(now);
  if (turn == PlaybackClock::Turn::kBeganAgain) return seek(clock_.first());
  if (turn == PlaybackClock::Turn::kEnded) Q_EMIT changed();
  const std::int64_t time = clock_.position(now);
  if (time <= position_) return;
  ++pending_;
  reader_->play(time);
}

void ReplaySession::startJump() {
  is_jumping_ = true;
  ++pending_;
  // A little more than the visible part of the plots, so that a small move shows no gap.
  past_read_ = std::min(past() + past() / 4, kLongestPast);
  reader_->jump(*std::exchange(wanted_, std::nullopt), past_read_, signals_.beginJump());
}

void ReplaySession::onStep(const ReplayStep& step) {
  if (state_ != State::kOpen) return;  // the requests that were made before the reader failed
  pending_ = std::max(0, pending_ - 1);
  const qint64 now = now_.nsecsElapsed();
  // If the disk is too slow, the replay takes longer, but leaves nothing out.
  const auto most = static_cast<double>(kMaxLate) * std::max(1.0, clock_.speed());
  const bool is_late =
      clock_.isPlaying() && static_cast<double>(clock_.position(now) - step.position) > most;
  if (is_late && !wanted_) clock_.seek(step.position, now);
  position_ = step.position;
  is_sought_ = step.is_jump;
  ShowMoment({.steady_ns = ReplayReader::SampleTime(position_, facts_.first),
              .wall_ns = position_,
              .recording = file_});
  if (step.catalogue) {
    // A jump within a time without changes does not update the views of the catalogue.
    if (!(*step.catalogue == store_.catalogue())) store_.replace(*step.catalogue);
  } else if (!step.changes.empty()) {
    store_.apply(step.changes);
  }
  if (step.is_jump) {
    is_jumping_ = false;
    read_from_ = position_ - past_read_;
    if (link_.state() != LinkState::State::kConnected) link_.setConnected();
    signals_.endJump();
    Q_EMIT reports_.beganAgain();
  }
  signals_.deliver();
  if (step.is_jump || !clock_.isPlaying() || !since_values_.isValid() ||
      since_values_.elapsed() >= kValuesPeriod) {
    since_values_.start();
    signals_.deliverValues();
  }
  if (step.log.is_current || !step.log.records.empty()) Q_EMIT reports_.logArrived(step.log);
  if (!step.events.empty()) Q_EMIT reports_.eventsArrived(step.events);
  if (step.problems.size() != facts_.problems.size()) {
    facts_.problems = step.problems;
    Q_EMIT changed();
  }
  Q_EMIT moved();
  advance();
}

void ReplaySession::togglePlaying() {
  if (state_ != State::kOpen) return;
  const qint64 now = now_.nsecsElapsed();
  if (clock_.isPlaying()) {
    clock_.pause(now);
  } else {
    clock_.play(now);
    if (clock_.position(now) < position_) wanted_ = clock_.position(now);  // it began again
  }
  Q_EMIT changed();
  advance();
}

void ReplaySession::setSpeed(double speed) {
  clock_.setSpeed(speed, now_.nsecsElapsed());
  Q_EMIT changed();
}

void ReplaySession::setLooping(bool looping) {
  clock_.setLooping(looping);
  Q_EMIT changed();
}

void ReplaySession::goTo(ReplayTarget target) {
  if (state_ != State::kOpen || isJumping() || finds_awaited_ > 0) return;
  clock_.pause(now_.nsecsElapsed());
  clock_.seek(position_, now_.nsecsElapsed());
  is_mark_wanted_ = false;
  awaitFinds(1);
  reader_->find(target);
  Q_EMIT changed();
}

void ReplaySession::goToMark(int direction) {
  if (state_ != State::kOpen || isJumping() || finds_awaited_ > 0) return;
  mark_direction_ = direction;
  mark_found_.reset();
  for (const std::int64_t mark : marks_) {
    if (direction > 0 ? mark <= position_ : mark >= position_) continue;
    if (direction > 0 && mark_found_) break;
    mark_found_ = mark;
  }
  clock_.pause(now_.nsecsElapsed());
  clock_.seek(position_, now_.nsecsElapsed());
  const bool is_next = direction > 0;
  is_mark_wanted_ = true;
  awaitFinds(2);
  reader_->find(is_next ? ReplayTarget::kNextEvent : ReplayTarget::kPreviousEvent);
  reader_->find(is_next ? ReplayTarget::kNextLoss : ReplayTarget::kPreviousLoss);
  Q_EMIT changed();
}

void ReplaySession::awaitFinds(int count) {
  pending_ += count;
  finds_awaited_ = count;
  is_find_overtaken_ = false;
}

void ReplaySession::onFound(std::optional<std::int64_t> time) {
  pending_ = std::max(0, pending_ - 1);
  finds_awaited_ = std::max(0, finds_awaited_ - 1);
  if (is_mark_wanted_) {
    if (time && mark_found_) {
      mark_found_ =
          mark_direction_ > 0 ? std::min(*mark_found_, *time) : std::max(*mark_found_, *time);
    } else if (time) {
      mark_found_ = time;
    }
    if (finds_awaited_ > 0) return;
    time = mark_found_;
    if (!time && !is_find_overtaken_) {
      Q_EMIT notice(mark_direction_ > 0
                        ? Words::tr("There is no event, loss or mark after this moment")
                        : Words::tr("There is no event, loss or mark before this moment"));
    }
  }
  if (!time || is_find_overtaken_) return advance();
  if (*time > position_ && clock_.position(now_.nsecsElapsed()) <= *time &&
      *time - position_ < kShortestPast) {
    // A small step forward needs no jump.
    clock_.seek(*time, now_.nsecsElapsed());
    return advance();
  }
  seek(*time);
}

void ReplaySession::setMarks(const QList<std::int64_t>& marks) {
  marks_ = marks;
  std::sort(marks_.begin(), marks_.end());
  Q_EMIT changed();
}

void ReplaySession::toggleMark() {
  if (state_ != State::kOpen) return;
  const auto same = [this](std::int64_t mark) { return std::abs(mark - position_) <= kSameMark; };
  if (marks_.removeIf(same) == 0) marks_ << position_;
  setMarks(marks_);
}

}  // namespace tendon::gui
