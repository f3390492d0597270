#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/window/empty_state.h>

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace tendon::gui {
namespace {

constexpr auto kUsualAddress = "127.0.0.1:10705";
constexpr int kWidth = 540;

}  // namespace

EmptyState::EmptyState(const GcmLink& link, QWidget* parent)
    : QWidget(parent), link_(link), title_(new QLabel), text_(new QLabel), command_(new QLineEdit) {
  setObjectName(QStringLiteral("emptyState"));
  SetRole(*title_, QStringLiteral("strong"));
  SetRole(*text_, QStringLiteral("dim"));
  text_->setWordWrap(true);
  command_->setReadOnly(true);
  command_->setAccessibleName(QStringLiteral("Command for a terminal"));
  SetRole(*command_, QStringLiteral("mono"));
  auto* copy = new QPushButton(QStringLiteral("Copy"));
  copy->setObjectName(QStringLiteral("copyStart"));
  connect(copy, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(command_->text()); });
  auto* line = new QHBoxLayout;
  line->setSpacing(2 * kGrid);
  line->addWidget(command_, 1);
  line->addWidget(copy);
  auto* body = new QWidget;
  body->setMaximumWidth(kWidth);
  auto* column = new QVBoxLayout(body);
  column->setSpacing(2 * kGrid);
  column->addWidget(title_);
  column->addWidget(text_);
  column->addLayout(line);
  auto* middle = new QHBoxLayout(this);
  middle->addStretch(1);
  middle->addWidget(body, 100, Qt::AlignVCenter);
  middle->addStretch(1);
  connect(&link, &GcmLink::changed, this, &EmptyState::refresh);
  refresh();
}

void EmptyState::refresh() {
  const bool usual = link_.address() == QLatin1String(kUsualAddress);
  const QString gcm = usual ? QString() : QStringLiteral(" --gcm ") + link_.address();
  if (link_.state() == GcmLink::State::kConnected) {
    title_->setText(QStringLiteral("Nothing is running yet."));
    text_->setText(
        QStringLiteral("Start a process that joins this GCM and it appears here by "
                       "itself. In a terminal:"));
    command_->setText(QStringLiteral("lcm --name robot --system demo.json") + gcm);
  } else {
    title_->setText(QStringLiteral("No GCM answers at %1.").arg(link_.address()));
    text_->setText(
        QStringLiteral("Looking every second; this window fills by itself when one "
                       "appears. To start one, in a terminal there:"));
    command_->setText(QStringLiteral("gcm serve") + gcm);
  }
  command_->setCursorPosition(0);
}

}  // namespace tendon::gui
