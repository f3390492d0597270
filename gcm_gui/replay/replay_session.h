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
#include <memory>
#include <optional>
#include <utility>

namespace tendon::gui {

/// A session that shows a recording instead of a running system: its catalogue, rows, events and
/// log at one moment, which the user chooses. It sets the time that the whole program shows, so a
/// program has at most one such session. GUI thread; no function waits.
class ReplaySession : public QObject {
  Q_OBJECT

 public:
  enum class State { kOpening, kOpen, kRefused };

  /// Opens the file in the background.
  explicit ReplaySession(const QString& file,
                         ReplayReader::OpenFile open_file = os::OpenRandomAccessFile);
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
  /// The reason why nothing can be changed.
  [[nodiscard]] const QString& reason() const { return reason_; }
  [[nodiscard]] State state() const { return state_; }
  /// The reason why the file cannot be shown.
  [[nodiscard]] const QString& refusal() const { return refusal_; }
  [[nodiscard]] const RecordingFacts& facts() const { return facts_; }
  [[nodiscard]] const PlaybackClock& clock() const { return clock_; }
  /// The shown moment, in ns since 1970.
  [[nodiscard]] std::int64_t position() const { return position_; }
  /// True if the moment was reached by a jump, not by playing.
  [[nodiscard]] bool isSought() const { return is_sought_; }
  /// True while a moment that the user has chosen is being read.
  [[nodiscard]] bool isJumping() const { return wanted_.has_value() || is_jumping_; }

  /// Times that the user has marked, sorted.
  [[nodiscard]] const QList<std::int64_t>& marks() const { return marks_; }
  void setMarks(const QList<std::int64_t>& marks);
  /// Marks the present moment, or removes its mark.
  void toggleMark();

  /// Sets the function that returns the length of the time that the plots show, in ns.
  void setPastWanted(std::function<std::int64_t()> past) { past_wanted_ = std::move(past); }
  /// Reads earlier rows if the plots show more than was read.
  void followPast();

 public Q_SLOTS:
  void togglePlaying();
  void setSpeed(double speed);
  void setLooping(bool looping);
  void seek(std::int64_t time);
  /// Stops playing, and goes to the next or previous row, event or loss.
  void goTo(tendon::gui::ReplayTarget target);
  /// Goes to the next event, loss or mark of the user (`direction` 1), or the previous one (-1).
  void goToMark(int direction);
  /// Opens the file again, because it may have grown. Keeps the shown moment.
  void reload();

 Q_SIGNALS:
  /// The state, the speed, the marks or the problems have changed.
  void changed();
  /// The shown moment has changed.
  void moved();
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  void onOpened(const RecordingFacts& facts);
  void onRefused(const QString& sentence);
  void onStep(const ReplayStep& step);
  void onFound(std::optional<std::int64_t> time);
  /// Requests the next step, unless a reply of the reader is still missing.
  void advance();
  void startJump();
  void awaitFinds(int count);
  [[nodiscard]] std::int64_t past() const;

  const QString file_;
  const ReplayReader::OpenFile open_file_;
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
  // Time before the moment of the latest jump for which rows were read, ns.
  std::int64_t past_read_ = 0;
  std::int64_t read_from_ = 0;          // earliest time with rows
  std::optional<std::int64_t> wanted_;  // target of the next jump
  std::optional<std::int64_t> reopened_at_;
  int pending_ = 0;  // number of missing replies of the reader
  bool is_jumping_ = false;
  bool is_sought_ = false;

  // The search for a mark has two steps, because events and losses must be read from the file.
  int mark_direction_ = 0;
  bool is_mark_wanted_ = false;
  int finds_awaited_ = 0;
  bool is_find_overtaken_ = false;  // the user has chosen another moment during the search
  std::optional<std::int64_t> mark_found_;

  std::unique_ptr<ReplayReader> reader_;
};

}  // namespace tendon::gui
