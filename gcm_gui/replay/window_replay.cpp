#include <gcm_gui/replay/window_replay.h>

#include <gcm_gui/commands/commands.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/plot/series/shown_time.h>
#include <gcm_gui/replay/recording_notes.h>
#include <gcm_gui/replay/replay_session.h>
#include <gcm_gui/replay/replay_strip.h>

#include <QMenu>
#include <algorithm>
#include <chrono>

namespace tendon::gui {
namespace {

constexpr std::chrono::milliseconds kPastPeriod{250};

}  // namespace

WindowReplay::WindowReplay(ReplaySession& session, RecordingNotes& notes, QObject* parent)
    : QObject(parent), session_(session), notes_(notes), strip_(new ReplayStrip(session)) {
  connect(&session, &ReplaySession::changed, this, Guarded(this, &WindowReplay::keep));
  connect(&session, &ReplaySession::moved, this, Guarded(this, &WindowReplay::showMoment));
  connect(&session, &ReplaySession::notice, this, &WindowReplay::notice);
  connect(strip_, &ReplayStrip::notice, this, &WindowReplay::notice);
}

WindowReplay::~WindowReplay() { session_.setPastWanted({}); }

void WindowReplay::setPlots(PlotPanel& plots) {
  plots_ = &plots;
  session_.setPastWanted([this] { return pastInSight(); });
  connect(&past_timer_, &QTimer::timeout, &session_, &ReplaySession::followPast);
  past_timer_.start(kPastPeriod);
}

std::int64_t WindowReplay::pastInSight() const {
  if (!IsMomentShown()) return 0;
  std::int64_t past = 0;
  for (int i = 0; i < plots_->plotCount(); ++i) {
    const TimeWindow& window = plots_->plot(i).timeWindow();
    past = std::max<std::int64_t>(
        past, window.isLive() ? window.length().count() : ShownTime() - window.firstTime());
  }
  return past;
}

/// If the shown moment leaves a held view, the view follows it again.
void WindowReplay::showMoment() {
  if (plots_ == nullptr || plots_->isPaused() || !session_.isSought()) return;
  const std::int64_t now = ShownTime();
  for (int i = 0; i < plots_->plotCount(); ++i) {
    PlotView& plot = plots_->plot(i);
    const bool is_in_sight =
        now >= plot.timeWindow().firstTime() && now <= plot.timeWindow().lastTime();
    if (!plot.isLive() && !is_in_sight) plot.gestures().goLiveTogether();
  }
}

void WindowReplay::keep() {
  if (session_.state() != ReplaySession::State::kOpen) return;
  const QString& file = session_.facts().file;
  const auto marks = notes_.marks(file);
  if (!is_known_) {
    is_known_ = true;
    notes_.addRecent(file);
    if (!marks.isEmpty()) session_.setMarks(marks);
    return;
  }
  if (session_.marks() != marks) notes_.setMarks(file, session_.marks());
}

void WindowReplay::addCommands(Commands& commands) {
  commands.menu(Commands::Menu::kRecord).setTitle(Words::tr("&Replay"));
  const auto add = [&](const QString& text, const QKeySequence& key, auto what) {
    commands.add(Commands::Menu::kRecord, text, key, what);
  };
  add(Words::tr("&Play or pause"), Qt::Key_Space, [this] { session_.togglePlaying(); });
  add(Words::tr("&Faster"), Qt::Key_BracketRight,
      [this] { session_.setSpeed(session_.clock().fasterSpeed()); });
  add(Words::tr("&Slower"), Qt::Key_BracketLeft,
      [this] { session_.setSpeed(session_.clock().slowerSpeed()); });
  commands.menu(Commands::Menu::kRecord).addSeparator();
  add(Words::tr("One row or event for&ward"), Qt::Key_Period,
      [this] { session_.goTo(ReplayTarget::kNextRow); });
  add(Words::tr("One row or event &back"), Qt::Key_Comma,
      [this] { session_.goTo(ReplayTarget::kPreviousRow); });
  add(Words::tr("&Next event, loss or mark"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Right),
      [this] { session_.goToMark(1); });
  add(Words::tr("P&revious event, loss or mark"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Left),
      [this] { session_.goToMark(-1); });
  add(Words::tr("To the be&ginning"), {}, [this] { session_.seek(session_.clock().first()); });
  add(Words::tr("To the &end"), {}, [this] { session_.seek(session_.clock().last()); });
  commands.menu(Commands::Menu::kRecord).addSeparator();
  add(Words::tr("&Mark this moment, or remove its mark"), Qt::Key_M,
      [this] { session_.toggleMark(); });
}

}  // namespace tendon::gui
