#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/fact_grid.h>

#include <QGridLayout>
#include <QLabel>
#include <QPainter>

namespace tendon::gui {

FactGrid::FactGrid(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
  grid_->setContentsMargins(kInset, 6, kInset, 6);
  grid_->setHorizontalSpacing(kInset);
  grid_->setVerticalSpacing(0);
  grid_->setColumnStretch(1, 1);
}

void FactGrid::show(const Facts& facts) {
  while (rows_.size() < facts.size()) {
    const auto row = static_cast<int>(rows_.size());
    auto* label = new QLabel(this);
    auto* value = new QLabel(this);
    SetRole(*label, QStringLiteral("dim"));
    SetRole(*value, QStringLiteral("mono"));
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    for (QLabel* cell : {label, value}) cell->setFixedHeight(kRowHeight);
    grid_->addWidget(label, row, 0);
    grid_->addWidget(value, row, 1);
    rows_.append(std::pair(label, value));
  }
  for (qsizetype row = 0; row < rows_.size(); ++row) {
    const auto [label, value] = rows_[row];
    const bool used = row < facts.size();
    label->setVisible(used);
    value->setVisible(used);
    if (!used) continue;
    label->setText(facts[row].first);
    value->setText(facts[row].second);
    value->setAccessibleName(facts[row].first);
    value->setToolTip(facts[row].second);
  }
}

void FactGrid::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(0, height() - 1, width(), 1, Theme::instance().color(Token::kLine));
}

}  // namespace tendon::gui
