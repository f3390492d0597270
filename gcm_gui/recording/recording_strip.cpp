#include <gcm_gui/recording/recording_strip.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/recording/recording_words.h>
#include <gcm_gui/theme/icon.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/link_button.h>
#include <gcm_gui/views/state_label.h>

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>
#include <cmath>

namespace tendon::gui {
namespace {

QLabel* MakeFigure(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(name));
  label->setTextFormat(Qt::PlainText);
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  SetRole(*label, QStringLiteral("mono dim"));
  return label;
}

/// The width of a figure never shrinks, so that its neighbours do not move when the figure changes.
void ShowFigure(QLabel& label, const QString& text) {
  label.setText(text);
  label.setMinimumWidth(std::max(label.minimumWidth(), label.sizeHint().width()));
}

}  // namespace

RecordingStrip::RecordingStrip(RecordingController& controller, QWidget* parent)
    : QFrame(parent),
      controller_(controller),
      dot_(new QLabel),
      title_(new QLabel),
      state_(new StateLabel),
      message_label_(new QLabel),
      interruptions_(new StateLabel),
      length_(MakeFigure("recordingLength")),
      rows_(MakeFigure("recordingRows")),
      rate_(MakeFigure("recordingRate")),
      size_(MakeFigure("recordingSize")),
      free_(MakeFigure("recordingDiskFree")),
      lost_(MakeFigure("recordingLost")),
      stop_(new QPushButton(Words::tr("Stop"))),
      show_(MakeLinkButton(Words::tr("Show in folder"), QStringLiteral("showRecording"))),
      copy_(MakeLinkButton(Words::tr("Copy path"), QStringLiteral("copyRecordingPath"))),
      folder_(
          MakeLinkButton(Words::tr("Choose a folder…"), QStringLiteral("chooseRecordingFolder"))),
      close_(new QToolButton) {
  setObjectName(QStringLiteral("recordingStrip"));
  setAutoFillBackground(true);
  setFixedHeight(kHeadHeight);
  build();
  connect(stop_, &QPushButton::clicked, &controller_, &RecordingController::stop);
  connect(close_, &QToolButton::clicked, &controller_, &RecordingController::dismissReport);
  connect(show_, &QToolButton::clicked, this,
          [this] { Q_EMIT showInFolderRequested(controller_.report()->file); });
  connect(copy_, &QToolButton::clicked, this,
          [this] { Q_EMIT copyPathRequested(controller_.report()->file); });
  connect(folder_, &QToolButton::clicked, this, &RecordingStrip::folderRequested);
  connect(&controller_, &RecordingController::changed, this,
          Guarded(this, &RecordingStrip::refresh));
  refresh();
}

void RecordingStrip::build() {
  const auto draw_dot = [this] {
    constexpr int kDot = 16;
    dot_->setPixmap(ThemeIcon(QStringLiteral("record"), Token::kBad).pixmap(kDot, kDot));
  };
  draw_dot();
  connect(&Theme::instance(), &Theme::changed, dot_, draw_dot);
  SetRole(*title_, QStringLiteral("strong"));
  state_->setObjectName(QStringLiteral("recordingState"));
  interruptions_->setObjectName(QStringLiteral("recordingInterruptions"));
  message_label_->setObjectName(QStringLiteral("recordingMessage"));
  message_label_->setTextFormat(Qt::PlainText);
  SetRole(*message_label_, QStringLiteral("dim"));
  // May be narrower than its text, so that it does not widen the window.
  message_label_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  stop_->setObjectName(QStringLiteral("stopRecording"));
  stop_->setAccessibleName(Words::tr("Stop the recording"));
  stop_->setToolTip(Words::tr("Completes the file  (Ctrl+R)"));
  stop_->setIcon(ThemeIcon(QStringLiteral("stop"), Token::kText));
  close_->setObjectName(QStringLiteral("closeRecordingReport"));
  close_->setIcon(ThemeIcon(QStringLiteral("close")));
  close_->setAccessibleName(Words::tr("Close this line"));
  close_->setToolTip(close_->accessibleName());
  rate_->setToolTip(Words::tr("Growth of the file in the last five seconds"));
  size_->setToolTip(Words::tr("Size of the file"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(kInset, 0, kInset, 0);
  row->setSpacing(kInset);
  row->addWidget(state_);
  auto* head = new QHBoxLayout;
  head->setSpacing(kGrid);
  head->addWidget(dot_);
  head->addWidget(title_);
  row->addLayout(head);
  row->addWidget(message_label_, 1);
  row->addWidget(interruptions_);
  for (QWidget* each : std::initializer_list<QWidget*>{length_, rows_, rate_, size_, free_, lost_,
                                                       stop_, show_, copy_, folder_, close_}) {
    row->addWidget(each);
  }
}

QString RecordingStrip::text() const {
  QStringList all{title_->isHidden() ? state_->text() : title_->text(), message_};
  for (const QLabel* figure : {length_, rows_, rate_, size_, free_, lost_}) {
    if (!figure->isHidden()) all << figure->text();
  }
  return all.join(' ');
}

void RecordingStrip::refresh() {
  const bool is_running = controller_.state() != RecordingController::State::kIdle;
  const bool has_figures = is_running && controller_.progress().seconds > 0.0;
  const auto& report = controller_.report();
  const bool has_file = !is_running && report && !report->file.isEmpty();
  const bool is_done = report && report->kind == RecordingReport::Kind::kDone;
  const bool has_failed = report && report->kind == RecordingReport::Kind::kFailed;
  for (QLabel* figure : {length_, rows_, rate_, size_, free_, lost_}) {
    figure->setVisible(has_figures);
    if (!has_figures) figure->setMinimumWidth(0);
  }
  const bool is_recording = controller_.state() == RecordingController::State::kRecording;
  dot_->setVisible(is_recording);
  title_->setVisible(is_recording);
  state_->setVisible(!is_recording);
  stop_->setVisible(is_running);
  stop_->setEnabled(controller_.state() != RecordingController::State::kStopping);
  interruptions_->setVisible(is_running && !controller_.interruptions().isEmpty());
  show_->setVisible(has_file);
  copy_->setVisible(has_file);
  folder_->setVisible(!is_running && has_failed);
  close_->setVisible(!is_running);
  if (is_running) {
    showRecording();
  } else if (report) {
    const bool is_calm = is_done && !report->has_losses;
    state_->show(is_calm ? StateMark::kActive : StateMark::kWarning, report->title);
    showReport(*report);
  }
  setVisible(is_running || report);
  setAccessibleName(text());
}

void RecordingStrip::showRecording() {
  const RecordingProgress& progress = controller_.progress();
  const auto& counts = progress.status.counts;
  const auto past = controller_.past().count();
  const QString saving = Words::tr("Saving the last %1 s").arg(past);
  title_->setText(past > 0 ? saving : Words::tr("Recording"));
  switch (controller_.state()) {
    case RecordingController::State::kStopping:
      state_->show(StateMark::kPending, Words::tr("Completing the file"));
      break;
    case RecordingController::State::kStarting:
      state_->show(StateMark::kPending, past > 0 ? saving : Words::tr("Starting to record"));
      break;
    default:
      break;
  }
  setMessage(controller_.subject() + QStringLiteral(" → ") + controller_.file());
  message_label_->setToolTip(controller_.patterns().join('\n') + '\n' + controller_.file());
  interruptions_->show(StateMark::kWarning, Words::tr("Was interrupted"));
  interruptions_->setToolTip(controller_.interruptions().join('\n'));
  ShowFigure(*length_, LengthText(progress.seconds));
  ShowFigure(*rows_, Words::tr("%1 rows").arg(counts.rows));
  rows_->setToolTip(Words::tr("%1 rows, %2 events, %3 commands, %4 records of the log")
                        .arg(counts.rows)
                        .arg(counts.events)
                        .arg(counts.commands)
                        .arg(counts.log));
  ShowFigure(*rate_, BytesText(static_cast<std::uint64_t>(std::llround(progress.rate))) +
                         QStringLiteral("/s"));
  ShowFigure(*size_, BytesText(counts.bytes));
  const QString warning = DiskWarning(progress);
  ShowFigure(*free_, Words::tr("%1 free").arg(BytesText(progress.status.disk_free)));
  SetRole(*free_, warning.isEmpty() ? QStringLiteral("mono dim") : QStringLiteral("mono warning"));
  free_->setToolTip(warning.isEmpty() ? Words::tr("Free space on the disk of the file") : warning);
  const std::uint64_t lost = progress.status.losses.all();
  ShowFigure(*lost_, Words::tr("%1 lost").arg(lost));
  SetRole(*lost_, lost == 0 ? QStringLiteral("mono dim") : QStringLiteral("mono warning"));
  lost_->setToolTip(lost == 0 ? Words::tr("Every row and event is in the file.")
                              : LossLines(progress.status.losses).join('\n'));
}

void RecordingStrip::showReport(const RecordingReport& report) {
  setMessage(report.detail);
  message_label_->setToolTip(report.detail);
}

void RecordingStrip::setMessage(const QString& message) {
  message_ = message;
  elideMessage();
}

void RecordingStrip::elideMessage() {
  const auto& report = controller_.report();
  const bool is_sentence = report && report->detail != report->file;
  message_label_->setText(message_label_->fontMetrics().elidedText(
      message_, is_sentence ? Qt::ElideRight : Qt::ElideMiddle, message_label_->width()));
}

void RecordingStrip::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  elideMessage();
}

}  // namespace tendon::gui
