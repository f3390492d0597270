#include <gcm_gui/help/shortcuts_card.h>

#include <gcm_gui/commands/commands.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/header_row.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QAction>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace tendon::gui {
namespace {

struct Key {
  QString keys;
  QString meaning;
};

struct KeyGroup {
  QString title;
  std::vector<Key> keys;
  // The object name of the widget that has these keys; null if they work everywhere.
  const char* part = nullptr;
};

QString KeysOf(const QAction& action) {
  return QKeySequence::listToString(action.shortcuts(), QKeySequence::NativeText)
      .replace(QStringLiteral("; "), QStringLiteral(", "));
}

KeyGroup OfMenu(const QMenu& menu) {
  KeyGroup group{menu.title().remove('&'), {}};
  for (const QAction* action : menu.actions()) {
    if (!action->shortcut().isEmpty()) group.keys.push_back({KeysOf(*action), PlainText(*action)});
  }
  return group;
}

/// Returns the keys that views handle themselves, without an action.
std::vector<KeyGroup> OfViews() {
  return {
      {Words::tr("Everywhere"),
       {{Words::tr("Tab, Shift+Tab"), Words::tr("Go to the next or previous part")},
        {Words::tr("Alt+S, P, R, G, V, H"), Words::tr("The menus")},
        {Words::tr("Esc"), Words::tr("Leave the connect mode, a card or a field")}}},
      {Words::tr("In the graph"),
       {{Words::tr("Arrows"), Words::tr("Select the next component")},
        {"+  −  0", Words::tr("Zoom in, zoom out, show all")},
        {Words::tr("1 … 9, Enter"),
         Words::tr(
             "While connecting: pick the candidate with this number, or the best candidate")}},
       "graph"},
      {Words::tr("In a plot"),
       {{"+  −", Words::tr("Zoom in time; with Ctrl in values")},
        {Words::tr("Left, Right"), Words::tr("Move in time")},
        {Words::tr("Alt+Left"), Words::tr("Back to the previous view")},
        {Words::tr("End"), Words::tr("Follow the data again")},
        {Words::tr("Ctrl+Left, Ctrl+Right, T"),
         Words::tr("Shift a recorded curve in time; T sets an exact shift")},
        {Words::tr("A, B, Delete"), Words::tr("Place or remove the cursors")}},
       "plotPanel"},
      {Words::tr("In a plot's legend"),
       {{Words::tr("Space"), Words::tr("Hide or show the curve")},
        {Words::tr("Delete"), Words::tr("Remove the curve")},
        {Words::tr("Enter"), Words::tr("Scale, offset and axis")},
        {"R", Words::tr("Show another signal instead")}},
       "legend"},
      {Words::tr("In a form"),
       {{Words::tr("Ctrl+Enter"),
         Words::tr("Call the command; if the command can move something, press these keys twice")}},
       "call"},
      {Words::tr("In the console"),
       {{Words::tr("Tab"), Words::tr("Completes")},
        {Words::tr("Ctrl+R"), Words::tr("Searches the history")},
        {Words::tr("Ctrl+C, Ctrl+L"), Words::tr("Interrupts; clears")}},
       "consolePage"}};
}

/// Returns the number of levels from `widget` up to the widget of the group; empty if that widget
/// is no parent.
std::optional<int> StepsTo(const KeyGroup& group, const QWidget* widget) {
  if (group.part == nullptr) return std::nullopt;
  for (int steps = 0; widget != nullptr; widget = widget->parentWidget(), ++steps) {
    if (widget->objectName() == QLatin1String(group.part)) return steps;
  }
  return std::nullopt;
}

/// Returns the group of the innermost widget that contains `widget` and has its own keys.
std::optional<KeyGroup> OfPart(const QWidget* widget) {
  std::optional<KeyGroup> nearest;
  int fewest = std::numeric_limits<int>::max();
  for (KeyGroup& group : OfViews()) {
    const auto steps = StepsTo(group, widget);
    if (!steps || *steps >= fewest) continue;
    fewest = *steps;
    nearest = std::move(group);
  }
  return nearest;
}

QWidget* MakeGroup(const KeyGroup& group) {
  auto* widget = new QWidget;
  widget->setAccessibleName(Words::tr("Keys: ") + group.title);
  auto* grid = new QGridLayout(widget);
  grid->setContentsMargins(0, 0, 0, 2 * kGrid);
  grid->setHorizontalSpacing(kInset);
  grid->setVerticalSpacing(kGrid);
  grid->setColumnStretch(1, 1);
  auto* title = new QLabel(group.title);
  SetRole(*title, QStringLiteral("strong"));
  grid->addWidget(title, 0, 0, 1, 2);
  for (const Key& key : group.keys) {
    const int row = grid->rowCount();
    auto* keys = new QLabel(key.keys);
    keys->setTextFormat(Qt::PlainText);
    SetRole(*keys, QStringLiteral("mono accent"));
    keys->setMinimumWidth(112);
    auto* meaning = new QLabel(key.meaning);
    meaning->setTextFormat(Qt::PlainText);
    meaning->setWordWrap(true);
    grid->addWidget(keys, row, 0, Qt::AlignTop);
    grid->addWidget(meaning, row, 1);
  }
  return widget;
}

}  // namespace

ShortcutsCard::ShortcutsCard(QWidget& place, const Commands& commands)
    : OverlayCard(place, new QWidget),
      commands_(commands),
      left_(new QVBoxLayout),
      right_(new QVBoxLayout) {
  setObjectName(QStringLiteral("keysCard"));
  setAccessibleName(Words::tr("Keys"));
  head().setTitle(Words::tr("Keys"));
  head().addRight(&leave());
  auto* columns = new QHBoxLayout(&body());
  columns->setContentsMargins(kInset, kInset, kInset, kGrid);
  columns->setSpacing(2 * kInset);
  columns->addLayout(left_, 1);
  columns->addLayout(right_, 1);
}

void ShortcutsCard::toggle() {
  if (!isHidden()) return close();
  fill();
  open();
}

void ShortcutsCard::toggleOf(const QWidget* focused) {
  const auto group = OfPart(focused);
  if (!group || !isHidden()) return toggle();
  clear();
  left_->addWidget(MakeGroup(*group));
  right_->addWidget(MakeGroup(OfViews().front()));
  left_->addStretch();
  right_->addStretch();
  open();
}

void ShortcutsCard::clear() {
  for (QBoxLayout* column : {left_, right_}) {
    while (QLayoutItem* item = column->takeAt(0)) {
      delete item->widget();
      delete item;
    }
  }
}

void ShortcutsCard::fill() {
  clear();
  for (const QMenu* menu : commands_.menus()) left_->addWidget(MakeGroup(OfMenu(*menu)));
  for (const KeyGroup& group : OfViews()) right_->addWidget(MakeGroup(group));
  left_->addStretch();
  right_->addStretch();
}

}  // namespace tendon::gui
