#include <gcm_gui/replay/replay_page.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/replay/replay_session.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace tendon::gui {
namespace {

constexpr int kTextWidth = 540;

}  // namespace

ReplayPage::ReplayPage(ReplaySession& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      title_(MakeTextLine(QStringLiteral("replayPageTitle"), QStringLiteral("strong"))),
      text_(MakeTextLine(QStringLiteral("replayPageText"), QStringLiteral("dim"))),
      open_(new QPushButton(Words::tr("Open another recording…"))) {
  setObjectName(QStringLiteral("replayPage"));
  open_->setObjectName(QStringLiteral("openAnotherRecording"));
  connect(open_, &QPushButton::clicked, this, &ReplayPage::openRequested);
  auto* body = new QWidget;
  body->setMaximumWidth(kTextWidth);
  auto* column = new QVBoxLayout(body);
  column->setSpacing(2 * kGrid);
  column->addWidget(title_);
  column->addWidget(text_);
  column->addSpacing(kGrid);
  column->addWidget(open_, 0, Qt::AlignLeft);
  auto* middle = new QHBoxLayout(this);
  middle->addStretch(1);
  middle->addWidget(body, 100, Qt::AlignVCenter);
  middle->addStretch(1);
  connect(&session, &ReplaySession::changed, this, Guarded(this, &ReplayPage::refresh));
  refresh();
}

QString ReplayPage::text() const { return title_->text() + ' ' + text_->text(); }

void ReplayPage::refresh() {
  open_->setVisible(session_.state() == ReplaySession::State::kRefused);
  switch (session_.state()) {
    case ReplaySession::State::kOpening:
      title_->setText(Words::tr("%1 is being opened").arg(session_.fileName()));
      text_->setText(
          Words::tr("A file without an index, such as a file that is still being "
                    "written, must first be read completely."));
      break;
    case ReplaySession::State::kRefused:
      title_->setText(Words::tr("%1 cannot be shown").arg(session_.fileName()));
      text_->setText(session_.refusal());
      break;
    case ReplaySession::State::kOpen:
      title_->setText(Words::tr("No component at this moment"));
      text_->setText(
          Words::tr("The recording has no component at this moment. Move the slider "
                    "above, or look at the catalogue and the log."));
      break;
  }
}

}  // namespace tendon::gui
