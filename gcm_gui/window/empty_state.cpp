#include <gcm_gui/window/empty_state.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/link_button.h>
#include <tendon/process/membership/advertised_address.h>

#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

namespace tendon::gui {
namespace {

constexpr int kTextWidth = 540;

/// Returns true if a GCM at the address of the link would start processes on this machine.
bool IsHere(const LinkState& link) {
  return link.isHosted() || link.address().startsWith(QStringLiteral("127.")) ||
         link.address().startsWith(QStringLiteral("localhost:")) ||
         link.address().startsWith(QStringLiteral("[::1]"));
}

}  // namespace

EmptyState::EmptyState(const LinkState& link, Offers offers, QWidget* parent)
    : QWidget(parent),
      link_(link),
      offers_(std::move(offers)),
      title_(new QLabel),
      text_(new QLabel),
      demo_(buildDemo()),
      start_(new QPushButton(Words::tr("Start a GCM here"))),
      terminal_(new QLabel),
      command_(new QLineEdit) {
  setObjectName(QStringLiteral("emptyState"));
  SetRole(*title_, QStringLiteral("strong"));
  SetRole(*text_, QStringLiteral("dim"));
  text_->setWordWrap(true);
  SetRole(*terminal_, QStringLiteral("dim"));
  command_->setReadOnly(true);
  command_->setAccessibleName(Words::tr("Command for a terminal"));
  SetRole(*command_, QStringLiteral("mono"));
  auto* copy = new QPushButton(Words::tr("Copy"));
  copy->setObjectName(QStringLiteral("copyStart"));
  connect(copy, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(command_->text()); });
  auto* line = new QHBoxLayout;
  line->setSpacing(2 * kGrid);
  line->addWidget(command_, 1);
  line->addWidget(copy);
  auto* body = new QWidget;
  body->setMaximumWidth(kTextWidth);
  auto* column = new QVBoxLayout(body);
  column->setSpacing(2 * kGrid);
  column->addWidget(title_);
  column->addWidget(text_);
  column->addWidget(demo_);
  column->addWidget(terminal_);
  column->addLayout(line);
  column->addSpacing(2 * kGrid);
  column->addLayout(buildWaysOn());
  if (offers_.recordings) column->addWidget(buildRecordings());
  auto* middle = new QHBoxLayout(this);
  middle->addStretch(1);
  middle->addWidget(body, 100, Qt::AlignVCenter);
  middle->addStretch(1);
  connect(&link, &LinkState::changed, this, Guarded(this, &EmptyState::refresh));
  refresh();
}

QWidget* EmptyState::buildDemo() {
  auto* demo = new QWidget;
  auto* start = new QPushButton(Words::tr("Try the demo"));
  start->setObjectName(QStringLiteral("tryDemo"));
  start->setProperty("changesSystem", true);
  SetRole(*start, QStringLiteral("primary"));
  connect(start, &QPushButton::clicked, this, &EmptyState::demoRequested);
  auto* meaning = new QLabel(Words::tr("Two processes with a simulated arm, on this machine."));
  SetRole(*meaning, QStringLiteral("dim"));
  auto* row = new QHBoxLayout(demo);
  row->setContentsMargins(0, kGrid, 0, 2 * kGrid);
  row->setSpacing(kInset);
  row->addWidget(start);
  row->addWidget(meaning, 1);
  return demo;
}

QLayout* EmptyState::buildWaysOn() {
  start_->setObjectName(QStringLiteral("startGcm"));
  SetRole(*start_, QStringLiteral("primary"));
  connect(start_, &QPushButton::clicked, this, &EmptyState::gcmRequested);
  auto* other = new QPushButton(Words::tr("Connect to another machine…"));
  other->setObjectName(QStringLiteral("otherMachine"));
  connect(other, &QPushButton::clicked, this, &EmptyState::otherRequested);
  auto* tour = new QPushButton(Words::tr("Show me around"));
  tour->setObjectName(QStringLiteral("showAround"));
  connect(tour, &QPushButton::clicked, this, &EmptyState::tourRequested);
  auto* row = new QHBoxLayout;
  row->setSpacing(2 * kGrid);
  for (QPushButton* button : {start_, other, tour}) row->addWidget(button);
  row->addStretch();
  return row;
}

QWidget* EmptyState::buildRecordings() {
  constexpr qsizetype kShown = 3;
  auto* recordings = new QWidget;
  auto* open = new QPushButton(Words::tr("Open a recording…"));
  open->setObjectName(QStringLiteral("openRecordingButton"));
  connect(open, &QPushButton::clicked, this, &EmptyState::recordingRequested);
  auto* row = new QHBoxLayout(recordings);
  row->setContentsMargins(0, 2 * kGrid, 0, 0);
  row->setSpacing(2 * kGrid);
  row->addWidget(open);
  for (const QString& file : offers_.recent.mid(0, kShown)) {
    constexpr int kNameWidth = 120;
    QToolButton* recent = MakeLinkButton({}, QStringLiteral("recentRecording"));
    recent->setText(
        recent->fontMetrics().elidedText(QFileInfo(file).fileName(), Qt::ElideMiddle, kNameWidth));
    recent->setToolTip(file);
    recent->setAccessibleName(Words::tr("Open %1").arg(file));
    connect(recent, &QToolButton::clicked, this, [this, file] { Q_EMIT recentRequested(file); });
    row->addWidget(recent);
  }
  row->addStretch();
  return recordings;
}

void EmptyState::refresh() {
  const QString gcm = ToQString(GcmWords(link_.address().toStdString()));
  const bool is_connected = link_.state() == LinkState::State::kConnected;
  if (is_connected) {
    title_->setText(Words::tr("Nothing is running yet."));
    text_->setText(Words::tr("A process that joins this GCM appears here automatically."));
    terminal_->setText(Words::tr("To start a process, type in a terminal:"));
    command_->setText(QStringLiteral("lcm --name robot --system demo.json") + gcm);
  } else {
    title_->setText(Words::tr("No GCM answers at %1.").arg(link_.address()));
    text_->setText(Words::tr("The window tries again every second until a GCM answers."));
    terminal_->setText(Words::tr("To start a GCM, type in a terminal of that machine:"));
    command_->setText(QStringLiteral("gcm serve") + gcm);
  }
  command_->setCursorPosition(0);
  demo_->setVisible(offers_.demo && is_connected && IsHere(link_));
  start_->setVisible(offers_.gcm && !is_connected && IsHere(link_));
}

}  // namespace tendon::gui
