#include <gcm_gui/window/lost_banner.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/state_label.h>

#include <QHBoxLayout>
#include <QLabel>

namespace tendon::gui {

LostBanner::LostBanner(const LinkState& link, QWidget* parent)
    : QFrame(parent), link_(link), since_(new StateLabel), meaning_(new QLabel) {
  setObjectName(QStringLiteral("lostBanner"));
  setAutoFillBackground(true);
  setFixedHeight(kHeadHeight);
  SetRole(*meaning_, QStringLiteral("dim"));
  // The label may be narrower than its text. Otherwise it would make the window wider.
  meaning_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  meaning_->setText(
      Words::tr("Values and plots continue, because they come directly from the processes."));
  meaning_->setToolTip(meaning_->text());
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(kInset, 0, kInset, 0);
  row->setSpacing(kInset);
  row->addWidget(since_);
  row->addWidget(meaning_, 1);
  connect(&link, &LinkState::changed, this, Guarded(this, &LostBanner::refresh));
  setNow(WallClock());
}

QString LostBanner::text() const { return since_->text() + ' ' + meaning_->text(); }

void LostBanner::setNow(qint64 now) {
  now_ = now;
  refresh();
}

void LostBanner::refresh() {
  setVisible(link_.state() == LinkState::State::kLost);
  since_->show(StateMark::kLost,
               Words::tr("Grey parts show the state of %1 ago").arg(AgeText(now_ - link_.since())));
  setAccessibleName(text());
}

}  // namespace tendon::gui
