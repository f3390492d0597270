#include <gcm_gui/views/tool_row.h>

#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QHBoxLayout>
#include <QLabel>

namespace tendon::gui {
namespace {

constexpr int kWidestField = 420;

}  // namespace

QWidget* MakeToolRow(std::initializer_list<QWidget*> left, std::initializer_list<QWidget*> right) {
  auto* widget = new QWidget;
  auto* row = new QHBoxLayout(widget);
  row->setContentsMargins(kInset - 2, kGrid, kInset - 6, kGrid);
  row->setSpacing(2 * kGrid);
  QWidget* last = nullptr;
  for (QWidget* one : left) row->addWidget(last = one);
  if (last != nullptr) {
    last->setMaximumWidth(kWidestField);
    row->setStretchFactor(last, 1);
  }
  row->addStretch();
  for (QWidget* one : right) row->addWidget(one);
  return widget;
}

QLabel* MakeNote(const QString& name) {
  auto* note = new QLabel;
  note->setObjectName(name);
  SetRole(*note, QStringLiteral("dim"));
  return note;
}

}  // namespace tendon::gui
