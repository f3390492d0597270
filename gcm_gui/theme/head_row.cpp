#include <gcm_gui/theme/head_row.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QHBoxLayout>
#include <QLabel>

namespace tendon::gui {

HeadRow::HeadRow(QWidget* parent) : QFrame(parent), row_(new QHBoxLayout(this)) {
  SetRole(*this, "head");
  setFixedHeight(kHeadHeight);
  row_->setContentsMargins(kInset, 0, kInset, 0);
  row_->setSpacing(kInset);
  row_->addStretch();
}

HeadRow::HeadRow(const QString& title, QWidget* parent) : HeadRow(parent) { setTitle(title); }

void HeadRow::setTitle(const QString& title) {
  if (title_ == nullptr) {
    title_ = new QLabel(this);
    SetRole(*title_, "strong");
    row_->insertWidget(0, title_);
    ++left_count_;
  }
  title_->setText(title);
  setAccessibleName(title);
}

void HeadRow::addLeft(QWidget* widget) { row_->insertWidget(left_count_++, widget); }

void HeadRow::addRight(QWidget* widget) { row_->addWidget(widget); }

}  // namespace tendon::gui
