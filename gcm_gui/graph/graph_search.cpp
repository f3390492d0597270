#include <gcm_gui/graph/graph_search.h>

#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/graph/highlight.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <algorithm>

namespace tendon::gui {
namespace {

constexpr int kFieldWidth = 200;
constexpr int kCountWidth = 88;

/// Returns the text of a component in which words are searched.
QString SearchText(const ComponentItem& item) {
  QString text = item.path();
  for (const PortItem* port : item.ports()) text += ' ' + ToQString(port->port().name.interface);
  return text;
}

}  // namespace

GraphSearch::GraphSearch(GraphView& graph)
    : QFrame(&graph), graph_(graph), field_(new QLineEdit), count_(new QLabel) {
  setObjectName(QStringLiteral("graphSearch"));
  setProperty("role", QStringLiteral("card"));
  setAutoFillBackground(true);
  field_->setObjectName(QStringLiteral("graphSearch.field"));
  field_->setAccessibleName(Words::tr("Find in the graph"));
  field_->setPlaceholderText(Words::tr("Component or interface"));
  field_->setFixedWidth(kFieldWidth);
  count_->setObjectName(QStringLiteral("graphSearch.count"));
  count_->setAlignment(Qt::AlignCenter);
  count_->setFixedWidth(kCountWidth);
  SetRole(*count_, QStringLiteral("dim"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
  row->setSpacing(kGrid);
  row->addWidget(field_);
  row->addWidget(count_);
  QToolButton* back = addButton(QStringLiteral("↑"), QStringLiteral("graphSearch.previous"),
                                Words::tr("Previous match  (Shift+Enter)"));
  QToolButton* on = addButton(QStringLiteral("↓"), QStringLiteral("graphSearch.next"),
                              Words::tr("Next match  (Enter)"));
  QToolButton* end = addButton(QStringLiteral("✕"), QStringLiteral("graphSearch.close"),
                               Words::tr("End the search  (Esc)"));
  connect(back, &QToolButton::clicked, this, &GraphSearch::previous);
  connect(on, &QToolButton::clicked, this, &GraphSearch::next);
  connect(end, &QToolButton::clicked, this, &GraphSearch::leave);
  connect(field_, &QLineEdit::textChanged, this, [this] {
    current_ = -1;
    search();
  });
  connect(&graph.graph(), &GraphScene::shown, this, [this] {
    if (isVisibleTo(&graph_)) search();
  });
  field_->installEventFilter(this);
  graph.installEventFilter(this);
  hide();
}

QToolButton* GraphSearch::addButton(const QString& text, const QString& name, const QString& help) {
  auto* button = new QToolButton;
  button->setText(text);
  button->setObjectName(name);
  button->setAccessibleName(help);
  button->setToolTip(help);
  button->setFixedSize(kRowHeight, kRowHeight);
  SetRole(*button, QStringLiteral("dim"));
  layout()->addWidget(button);
  return button;
}

void GraphSearch::open() {
  show();
  raise();
  moveToEdge();
  field_->setFocus(Qt::ShortcutFocusReason);
  field_->selectAll();
  search();
}

bool GraphSearch::leave() {
  if (!isVisibleTo(&graph_)) return false;
  const bool had_focus = isAncestorOf(window()->focusWidget());
  hide();
  graph_.graph().highlight().setFound({});
  if (had_focus) graph_.setFocus();
  return true;
}

void GraphSearch::search() {
  const QString current = current_ < 0 ? QString() : found_.value(current_);
  const QStringList words = field_->text().split(' ', Qt::SkipEmptyParts);
  found_.clear();
  Highlight::Names names;
  for (const auto& [path, item] : graph_.graph().components()) {
    const QString text = words.isEmpty() ? QString() : SearchText(*item);
    const bool fits = std::all_of(words.begin(), words.end(), [&](const QString& word) {
      return text.contains(word, Qt::CaseInsensitive);
    });
    if (words.isEmpty() || !fits) continue;
    found_.append(path);
    names.components.insert(path);
  }
  current_ = found_.indexOf(current);
  graph_.graph().highlight().setFound(std::move(names));
  showCount();
}

void GraphSearch::go(int way) {
  if (found_.isEmpty()) return;
  const bool is_first = current_ < 0 && way > 0;
  current_ =
      is_first ? 0 : (std::max<qsizetype>(current_, 0) + way + found_.size()) % found_.size();
  showCount();
  Q_EMIT chosen(found_.at(current_));
}

void GraphSearch::showCount() {
  QString text;
  if (!field_->text().trimmed().isEmpty()) {
    text = found_.isEmpty() ? Words::tr("no match")
           : current_ < 0   ? Words::tr("%1 found").arg(found_.size())
                            : Words::tr("%1 of %2").arg(current_ + 1).arg(found_.size());
  }
  count_->setText(text);
  field_->setAccessibleDescription(text);
}

void GraphSearch::moveToEdge() {
  adjustSize();
  move(graph_.width() - width() - 2 * kGrid, 2 * kGrid);
}

bool GraphSearch::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && watched == &graph_) moveToEdge();
  if (event->type() != QEvent::KeyPress || watched != field_) {
    return QFrame::eventFilter(watched, event);
  }
  const auto& key = static_cast<const QKeyEvent&>(*event);
  if (key.key() == Qt::Key_Escape) return leave();
  if (key.key() != Qt::Key_Return && key.key() != Qt::Key_Enter) return false;
  go(key.modifiers().testFlag(Qt::ShiftModifier) ? -1 : 1);
  return true;
}

}  // namespace tendon::gui
