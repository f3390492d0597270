#include <gcm_gui/commands/command_palette.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/views/row_view.h>

#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace tendon::gui {
namespace {

constexpr int kPaletteWidth = 560;
constexpr int kRowsSeen = 14;

}  // namespace

CommandPalette::CommandPalette(QList<QAction*> actions, const CatalogueModel& catalogue,
                               QWidget& window)
    : QFrame(&window), model_(std::move(actions), catalogue), field_(new QLineEdit) {
  setObjectName(QStringLiteral("palette"));
  setAccessibleName(Words::tr("Search or run"));
  setAutoFillBackground(true);
  field_->setObjectName(QStringLiteral("palette.field"));
  field_->setAccessibleName(Words::tr("A command, or the name of an object"));
  field_->setPlaceholderText(Words::tr("A command, or the name of an object"));
  list_ = MakeRowList(model_, QStringLiteral("palette.list"), Words::tr("Search or run"),
                      Words::tr("No match."));
  list_->setFocusPolicy(Qt::NoFocus);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
  column->setSpacing(2 * kGrid);
  column->addWidget(field_);
  column->addWidget(list_, 1);
  field_->installEventFilter(this);
  connect(field_, &QLineEdit::textChanged, this, &CommandPalette::find);
  connect(list_, &QTreeView::clicked, this, &CommandPalette::choose);
  hide();
}

void CommandPalette::open() {
  const QWidget& window = *parentWidget();
  const int height = (kRowsSeen + 2) * kRowHeight;
  const int width = std::min(kPaletteWidth, window.width() - 2 * kInset);
  setGeometry((window.width() - width) / 2, kTopBarHeight, width,
              std::min(height, window.height() - kTopBarHeight - kInset));
  if (!isVisible()) before_ = window.focusWidget();
  field_->clear();
  find({});
  show();
  raise();
  field_->setFocus(Qt::ShortcutFocusReason);
}

void CommandPalette::find(const QString& words) {
  model_.find(words);
  list_->setCurrentIndex(model_.index(0, 0));
}

void CommandPalette::leave() {
  hide();
  if (before_ != nullptr) before_->setFocus();
}

void CommandPalette::choose(const QModelIndex& index) {
  if (!index.isValid()) return;
  const PaletteRow row = model_.row(index.row());
  leave();
  if (row.action != nullptr) {
    row.action->trigger();
  } else {
    Q_EMIT pathChosen(row.text);
  }
}

bool CommandPalette::press(int key) {
  switch (key) {
    case Qt::Key_Escape:
      leave();
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      choose(list_->currentIndex());
      return true;
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown: {
      QKeyEvent copy(QEvent::KeyPress, key, Qt::NoModifier);
      QCoreApplication::sendEvent(list_, &copy);
      return true;
    }
    default:
      return false;
  }
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();  // so that Escape closes the palette and triggers no shortcut of the window
    return true;
  }
  if (event->type() == QEvent::KeyPress && press(static_cast<QKeyEvent*>(event)->key())) {
    return true;
  }
  if (event->type() == QEvent::FocusOut &&
      static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason) {
    hide();
  }
  return QFrame::eventFilter(watched, event);
}

}  // namespace tendon::gui
