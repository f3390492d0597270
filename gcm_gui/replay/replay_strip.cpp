#include <gcm_gui/replay/replay_strip.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/recording/recording_words.h>
#include <gcm_gui/replay/replay_session.h>
#include <gcm_gui/replay/replay_stripe.h>
#include <gcm_gui/theme/icon.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/link_button.h>
#include <gcm_gui/views/state_label.h>

#include <QClipboard>
#include <QComboBox>
#include <QDateTime>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <array>
#include <chrono>

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;

constexpr auto kBusyAfter = 300ms;

QLabel* MakeMoment(const QString& name, Qt::Alignment alignment) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setAlignment(alignment | Qt::AlignVCenter);
  SetRole(*label, QStringLiteral("mono"));
  return label;
}

std::vector<TimeSlider::Span> SpansOf(const std::vector<recording::PlayedSpan>& played) {
  std::vector<TimeSlider::Span> spans;
  for (const auto& span : played) {
    spans.push_back({static_cast<std::int64_t>(span.from), static_cast<std::int64_t>(span.to)});
  }
  return spans;
}

/// Returns the command that repairs a damaged file.
QString RecoverCommand(const QString& file) {
  const QFileInfo info(file);
  const QString whole = info.path() + '/' + info.completeBaseName() + QStringLiteral("-whole.mcap");
  return QStringLiteral("gcm recover %1 -o %2").arg(ShellWord(file), ShellWord(whole));
}

}  // namespace

ReplayStrip::ReplayStrip(ReplaySession& session, QWidget* parent)
    : QFrame(parent),
      session_(session),
      stripe_(new ReplayStripe),
      play_(new QPushButton),
      moment_(MakeMoment(QStringLiteral("replayMoment"), Qt::AlignRight)),
      length_(MakeMoment(QStringLiteral("replayLength"), Qt::AlignLeft)),
      slider_(new TimeSlider),
      busy_(new QProgressBar),
      speed_(new QComboBox),
      loop_(new QToolButton) {
  setObjectName(QStringLiteral("replayStrip"));
  controls_ = buildControls();
  warning_ = buildWarning();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGap);
  column->addWidget(stripe_);
  column->addWidget(controls_);
  column->addWidget(warning_);
  connect(&session, &ReplaySession::changed, this, Guarded(this, &ReplayStrip::refresh));
  connect(&session, &ReplaySession::moved, this, Guarded(this, &ReplayStrip::showMoment));
  refresh();
}

QToolButton* ReplayStrip::addButton(const QString& icon, const QString& name, const QString& text,
                                    const QString& key) {
  auto* button = new QToolButton;
  button->setObjectName(name);
  button->setIcon(ThemeIcon(icon, Token::kText));
  button->setAccessibleName(text);
  button->setToolTip(key.isEmpty() ? text : text + QStringLiteral("  (") + key + ')');
  return button;
}

QWidget* ReplayStrip::buildControls() {
  auto* controls = new QFrame;
  controls->setObjectName(QStringLiteral("replayControls"));
  controls->setAutoFillBackground(true);
  controls->setFixedHeight(kTopBarHeight);
  auto* row = new QHBoxLayout(controls);
  row->setContentsMargins(kInset, 0, kInset, 0);
  row->setSpacing(kGrid);
  const auto add = [&](const QString& icon, const char* name, const QString& text,
                       const QString& key, auto what) {
    QToolButton* button = addButton(icon, QString::fromLatin1(name), text, key);
    connect(button, &QToolButton::clicked, this, what);
    row->addWidget(button);
    return button;
  };
  add(QStringLiteral("skip_back"), "replayFormerMark", Words::tr("Previous event, loss or mark"),
      QStringLiteral("Ctrl+Shift+Left"), [this] { session_.goToMark(-1); });
  add(QStringLiteral("back"), "replayStepBack", Words::tr("One row or event back"),
      QStringLiteral(","), [this] { session_.goTo(ReplayTarget::kPreviousRow); });
  play_->setObjectName(QStringLiteral("replayPlay"));
  SetRole(*play_, QStringLiteral("primary"));
  connect(play_, &QPushButton::clicked, &session_, &ReplaySession::togglePlaying);
  row->addWidget(play_);
  add(QStringLiteral("forward"), "replayStep", Words::tr("One row or event forward"),
      QStringLiteral("."), [this] { session_.goTo(ReplayTarget::kNextRow); });
  add(QStringLiteral("skip_forward"), "replayNextMark", Words::tr("Next event, loss or mark"),
      QStringLiteral("Ctrl+Shift+Right"), [this] { session_.goToMark(1); });
  row->addSpacing(kGrid);
  row->addWidget(moment_);
  row->addWidget(slider_, 1);
  busy_->setObjectName(QStringLiteral("replayBusy"));
  busy_->setRange(0, 0);
  busy_->setTextVisible(false);
  busy_->setFixedHeight(kGrid);
  busy_->setAccessibleName(Words::tr("The recording is being opened"));
  busy_->hide();
  row->addWidget(busy_, 1);
  row->addWidget(length_);
  row->addSpacing(kGrid);
  setUpChoices();
  row->addWidget(speed_);
  row->addWidget(loop_);
  add(QStringLiteral("flag"), "replayMark", Words::tr("Mark this moment, or remove its mark"),
      QStringLiteral("M"), [this] { session_.toggleMark(); });
  connect(slider_, &TimeSlider::sought, &session_, &ReplaySession::seek);
  connect(slider_, &TimeSlider::stepRequested, this, [this](int direction) {
    session_.goTo(direction > 0 ? ReplayTarget::kNextRow : ReplayTarget::kPreviousRow);
  });
  return controls;
}

void ReplayStrip::setUpChoices() {
  speed_->setObjectName(QStringLiteral("replaySpeed"));
  speed_->setAccessibleName(Words::tr("Speed"));
  speed_->setToolTip(Words::tr("How fast the recording is played"));
  for (const double speed : PlaybackClock::kSpeeds)
    speed_->addItem(QString::number(speed) + QStringLiteral("×"));
  connect(speed_, &QComboBox::activated, this, [this](int index) {
    session_.setSpeed(PlaybackClock::kSpeeds.at(static_cast<std::size_t>(index)));
  });
  loop_->setObjectName(QStringLiteral("replayLoop"));
  loop_->setCheckable(true);
  loop_->setIcon(ThemeIcon(QStringLiteral("loop"), Token::kText));
  loop_->setAccessibleName(Words::tr("Restart at the end"));
  loop_->setToolTip(loop_->accessibleName());
  connect(loop_, &QToolButton::toggled, &session_, &ReplaySession::setLooping);
}

QWidget* ReplayStrip::buildWarning() {
  auto* line = new QFrame;
  line->setObjectName(QStringLiteral("replayWarning"));
  line->setAutoFillBackground(true);
  line->setFixedHeight(kHeadHeight);
  warning_state_ = new StateLabel;
  warning_label_ = new QLabel;
  warning_label_->setObjectName(QStringLiteral("replayWarningText"));
  warning_label_->setTextFormat(Qt::PlainText);
  warning_label_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  SetRole(*warning_label_, QStringLiteral("dim"));
  copy_ = MakeLinkButton(Words::tr("Copy the command gcm recover"), QStringLiteral("copyRecover"));
  connect(copy_, &QToolButton::clicked, this, [this] {
    QGuiApplication::clipboard()->setText(RecoverCommand(session_.file()));
    Q_EMIT notice(Words::tr("In the clipboard: %1").arg(RecoverCommand(session_.file())));
  });
  reload_ = MakeLinkButton(Words::tr("Load newer data"), QStringLiteral("reloadRecording"));
  connect(reload_, &QToolButton::clicked, &session_, &ReplaySession::reload);
  auto* close = new QToolButton;
  close->setObjectName(QStringLiteral("closeReplayWarning"));
  close->setIcon(ThemeIcon(QStringLiteral("close")));
  close->setAccessibleName(Words::tr("Close this line"));
  close->setToolTip(close->accessibleName());
  connect(close, &QToolButton::clicked, this, [this] {
    is_dismissed_ = true;
    showWarning();
  });
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(kInset, 0, kInset, 0);
  row->setSpacing(kInset);
  row->addWidget(warning_state_);
  row->addWidget(warning_label_, 1);
  for (QToolButton* button : {copy_, reload_, close}) row->addWidget(button);
  return line;
}

void ReplayStrip::refresh() {
  const bool is_open = session_.state() == ReplaySession::State::kOpen;
  const bool is_opening = session_.state() == ReplaySession::State::kOpening;
  const bool is_playing = session_.clock().isPlaying();
  for (auto* button : controls_->findChildren<QAbstractButton*>()) button->setEnabled(is_open);
  speed_->setEnabled(is_open);
  slider_->setEnabled(is_open);
  controls_->setVisible(session_.state() != ReplaySession::State::kRefused);
  if (is_opening) {
    QTimer::singleShot(kBusyAfter, this, [this] {
      if (session_.state() != ReplaySession::State::kOpening) return;
      slider_->hide();
      busy_->show();
    });
  } else {
    busy_->hide();
    slider_->setVisible(is_open);
  }
  play_->setIcon(ThemeIcon(is_playing ? QStringLiteral("pause") : QStringLiteral("play"),
                           is_open ? Token::kOnAccent : Token::kStale));
  play_->setAccessibleName(is_playing ? Words::tr("Pause") : Words::tr("Play"));
  play_->setToolTip(play_->accessibleName() + QStringLiteral("  (") + Words::tr("Space") + ')');
  const auto speed = std::find(PlaybackClock::kSpeeds.begin(), PlaybackClock::kSpeeds.end(),
                               session_.clock().speed());
  speed_->setCurrentIndex(speed == PlaybackClock::kSpeeds.end()
                              ? -1
                              : static_cast<int>(speed - PlaybackClock::kSpeeds.begin()));
  if (is_open) {
    const RecordingFacts& facts = session_.facts();
    slider_->setRange(facts.first, facts.last);
    slider_->setEvents(SpansOf(facts.events));
    slider_->setLosses(SpansOf(facts.losses));
    std::vector<TimeSlider::Span> marks;
    for (const std::int64_t mark : session_.marks()) marks.push_back({mark, mark});
    slider_->setMarks(std::move(marks));
    length_->setText(MomentText(facts.last - facts.first));
    // The label is as wide as the longest text, so that the slider does not move.
    moment_->setFixedWidth(
        moment_->fontMetrics().horizontalAdvance(MomentText(facts.last - facts.first)) + kGrid);
  }
  showMoment();
  showWarning();
}

void ReplayStrip::showMoment() {
  const RecordingFacts& facts = session_.facts();
  switch (session_.state()) {
    case ReplaySession::State::kOpening:
      return stripe_->show(session_.fileName(), Words::tr("is being opened…"), {});
    case ReplaySession::State::kRefused:
      return stripe_->show(session_.fileName(), Words::tr("cannot be shown"), {});
    case ReplaySession::State::kOpen:
      break;
  }
  const QDateTime begin = QDateTime::fromMSecsSinceEpoch(facts.first / 1'000'000);
  const QString day = QLocale().toString(begin.date(), QLocale::ShortFormat);
  stripe_->show(
      session_.fileName(),
      Words::tr("recorded on %1 at %2").arg(day, begin.toString(QStringLiteral("hh:mm:ss"))),
      ClockText(session_.position()));
  moment_->setText(MomentText(session_.position() - facts.first));
  // While the user drags, the handle follows the mouse.
  if (!slider_->isSliderDown() && !session_.isJumping()) slider_->setTime(session_.position());
}

void ReplayStrip::showWarning() {
  const RecordingFacts& facts = session_.facts();
  const QString end = ClockText(facts.last);
  warning_text_.clear();
  if (session_.state() == ReplaySession::State::kOpen) {
    if (facts.is_growing) {
      warning_text_ = Words::tr("The file is still being written; it is shown up to %1").arg(end);
    } else if (facts.has_no_end) {
      warning_text_ = Words::tr(
                          "The end of the file is missing or damaged; it is shown up to %1. "
                          "To repair it: gcm recover")
                          .arg(end);
    } else if (!facts.problems.isEmpty()) {
      warning_text_ = Words::tr(
                          "Parts of the file are damaged and are left out: %1. To repair it: "
                          "gcm recover")
                          .arg(facts.problems.front());
    }
  }
  warning_state_->show(StateMark::kWarning,
                       facts.is_growing ? Words::tr("Not complete") : Words::tr("Damaged"));
  warning_label_->setToolTip((QStringList{warning_text_} + facts.problems).join('\n'));
  copy_->setVisible(!facts.is_growing);
  reload_->setVisible(facts.is_growing);
  warning_->setVisible(!warning_text_.isEmpty() && !is_dismissed_);
  warning_->setAccessibleName(warning_text_);
  elideWarning();
}

void ReplayStrip::elideWarning() {
  warning_label_->setText(warning_label_->fontMetrics().elidedText(warning_text_, Qt::ElideRight,
                                                                   warning_label_->width()));
}

void ReplayStrip::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  elideWarning();
}

}  // namespace tendon::gui
