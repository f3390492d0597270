#pragma once

#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/replay/playback_clock.h>
#include <gcm_gui/replay/replay_reader.h>
#include <gcm_gui/replay/replay_refusals.h>
#include <gcm_gui/replay/replay_signals.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/link_state.h>

#include <QElapsedTimer>
#include <QList>
#include <QObject>
#include <QString>
#include <QTimer>
#include <cstdint>
#include <functional>
#include <optional>

namespace tendon::gui {

/// A recording in the place of a running system: the same catalogue, rows, events and log, as of
/// one moment, which the user moves. Sets the time that the whole program shows, so a program has
/// at most one. GUI thread; no function waits.
class ReplaySession : public QObject {
  Q_OBJECT

 public:
  enum class State { kOpening, kOpen, kRefused };

  /// Opens the file in the background.
  explicit ReplaySession(const QString& file);
  ~ReplaySession() override;

  [[nodiscard]] CatalogueStore& store() { return store_; }
  [[nodiscard]] LinkState& link() { return link_; }
  [[nodiscard]] ActivityModel& activity() { return activity_; }
  [[nodiscard]] ReplaySignals& signalSource() { return signals_; }
  [[nodiscard]] ReplayReports& reports() { return reports_; }
  [[nodiscard]] ReplayRefusals& refusals() { return refusals_; }
  [[nodiscard]] ReplayRecordings& recordings() { return recordings_; }

  [[nodiscard]] const QString& file() const { return file_; }
  [[nodiscard]] QString fileName() const;
  /// Why nothing can be changed.
  [[nodiscard]] const QString& reason() const { return reason_; }
  [[nodiscard]] State state() const { return state_; }
  /// Why the file cannot be shown.
  [[nodiscard]] const QString& refusal() const { return refusal_; }
  [[nodiscard]] const RecordingFacts& facts() const { return facts_; }
  [[nodiscard]] const PlaybackClock& clock() const { return clock_; }
  /// The moment that is shown, ns since 1970.
  [[nodiscard]] std::int64_t position() const { return position_; }
  /// True if the moment was reached by a jump, not by playing.
  [[nodiscard]] bool isSought() const { return is_sought_; }
  /// True while a moment that the user has chosen is being read.
  [[nodiscard]] bool isJumping() const { return wanted_.has_value() || is_jumping_; }

  /// Times that the user has marked, sorted.
  [[nodiscard]] const QList<std::int64_t>& marks() const { return marks_; }
  void setMarks(const QList<std::int64_t>& marks);
  /// Marks the present moment, or removes the mark from it.
  void toggleMark();

  /// Sets the function that returns how much of the past the plots show, in ns.
  void setPastWanted(std::function<std::int64_t()> past) { past_wanted_ = std::move(past); }
  /// Reads more of the past if the plots show more than there is.
  void followPast();

 public Q_SLOTS:
  void togglePlaying();
  void setSpeed(double speed);
  void setLooping(bool looping);
  void seek(std::int64_t time);
  /// Goes to the next or previous row, event or loss; stops playing.
  void goTo(tendon::gui::ReplayTarget target);
  /// Goes to the next event, loss or mark of the user (`direction` 1), or the previous one (-1).
  void goToMark(int direction);
  /// Opens the file again at this moment, for what was written into it since.
  void reload();

 Q_SIGNALS:
  /// State, speed, marks or problems have changed.
  void changed();
  /// Another moment is shown.
  void moved();
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  void onOpened(const RecordingFacts& facts);
  void onRefused(const QString& sentence);
  void onStep(const ReplayStep& step);
  void onFound(std::optional<std::int64_t> time);
  /// Asks for what comes next, unless an answer is outstanding.
  void advance();
  void startJump();
  void awaitFinds(int count);
  [[nodiscard]] std::int64_t past() const;

  const QString file_;
  const QString reason_;
  CatalogueStore store_;
  LinkState link_;
  ActivityModel activity_;
  ReplayReports reports_;
  ReplayRefusals refusals_;
  ReplayRecordings recordings_;
  ReplaySignals signals_;
  State state_ = State::kOpening;
  QString refusal_;
  RecordingFacts facts_;
  PlaybackClock clock_;
  QElapsedTimer now_;
  QElapsedTimer since_values_;
  QTimer timer_;
  QTimer soon_;
  QList<std::int64_t> marks_;
  std::function<std::int64_t()> past_wanted_;
  std::int64_t position_ = 0;
  std::int64_t past_read_ = 0;          // ns before the latest jump
  std::int64_t read_from_ = 0;          // the earliest time of which there are rows
  std::optional<std::int64_t> wanted_;  // the moment of the next jump
  std::optional<std::int64_t> reopened_at_;
  int pending_ = 0;  // answers of the reader
  bool is_jumping_ = false;
  bool is_sought_ = false;

  // Marks are searched for in two steps, because events and losses are in the file.
  int mark_direction_ = 0;
  bool is_mark_wanted_ = false;
  int finds_awaited_ = 0;
  bool is_find_overtaken_ = false;  // the user has chosen another moment since
  std::optional<std::int64_t> mark_found_;

  std::unique_ptr<ReplayReader> reader_;
};

}  // namespace tendon::gui
