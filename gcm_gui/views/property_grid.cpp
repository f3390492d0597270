#include <gcm_gui/views/property_grid.h>

#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QGridLayout>
#include <QLabel>
#include <QPainter>

namespace tendon::gui {
namespace {

constexpr int kAboveValue = 4;  // pixels; aligns the first line of a value with its name

void ShowFact(const Property& fact, QLabel& name, QLabel& value) {
  const bool words = fact.kind == Property::Kind::kSentence;
  name.setText(fact.name);
  name.setToolTip(fact.help);
  SetRole(value, words ? QString() : QStringLiteral("mono"));
  value.setAlignment((words ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignTop);
  value.setText(fact.value);
  value.setAccessibleName(fact.name);
  value.setToolTip(fact.help.isEmpty() ? fact.value : fact.help);
}

}  // namespace

PropertyGrid::PropertyGrid(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
  grid_->setContentsMargins(kInset, 6, kInset, 6);
  grid_->setHorizontalSpacing(kInset);
  grid_->setVerticalSpacing(0);
  grid_->setColumnStretch(1, 1);
}

void PropertyGrid::addRow() {
  const auto row = static_cast<int>(rows_.size());
  auto* name = new QLabel(this);
  auto* value = new QLabel(this);
  SetRole(*name, QStringLiteral("dim"));
  name->setFixedHeight(kRowHeight);
  value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  value->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
  value->setMinimumHeight(kRowHeight);
  value->setContentsMargins(0, kAboveValue, 0, 0);
  value->setWordWrap(true);
  grid_->addWidget(name, row, 0, Qt::AlignTop);
  grid_->addWidget(value, row, 1);
  rows_.append(std::pair(name, value));
}

void PropertyGrid::show(const QList<Property>& facts) {
  while (rows_.size() < facts.size()) addRow();
  for (qsizetype row = 0; row < rows_.size(); ++row) {
    const auto [name, value] = rows_[row];
    const bool used = row < facts.size();
    name->setVisible(used);
    value->setVisible(used);
    if (used) ShowFact(facts[row], *name, *value);
  }
}

void PropertyGrid::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(0, height() - 1, width(), 1, Theme::instance().color(Token::kLine));
}

}  // namespace tendon::gui
