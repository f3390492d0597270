#include <gcm_gui/theme/header_row.h>

#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QHBoxLayout>
#include <QLabel>

namespace tendon::gui {

HeaderRow::HeaderRow(QWidget* parent) : QFrame(parent), row_(new QHBoxLayout(this)) {
  SetRole(*this, "head");
  setFixedHeight(kHeadHeight);
  row_->setContentsMargins(kInset, 0, kInset, 0);
  row_->setSpacing(kInset);
  row_->addStretch();
}

HeaderRow::HeaderRow(const QString& title, QWidget* parent) : HeaderRow(parent) { setTitle(title); }

void HeaderRow::setTitle(const QString& title) {
  if (title_ == nullptr) {
    title_ = new QLabel(this);
    SetRole(*title_, "strong");
    row_->insertWidget(0, title_);
    ++left_count_;
  }
  title_->setText(title);
  setAccessibleName(title);
}

void HeaderRow::addLeft(QWidget* widget) { row_->insertWidget(left_count_++, widget); }

void HeaderRow::addRight(QWidget* widget) { row_->addWidget(widget); }

}  // namespace tendon::gui
