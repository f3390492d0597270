#include <gcm_gui/views/row_view.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/tendon_style.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/row_delegate.h>

#include <QHeaderView>
#include <QPainter>
#include <QScrollBar>
#include <QVBoxLayout>

namespace tendon::gui {
namespace {

constexpr int kTreeInset = 6;  // pixels from the edge to the arrows

}  // namespace

RowView::RowView(QWidget* parent) : QTreeView(parent), delegate_(new RowDelegate(this)) {
  setItemDelegate(delegate_);
  setHeaderHidden(true);
  setUniformRowHeights(true);
  setFrameShape(QFrame::NoFrame);
  setIndentation(kIndent);
  delegate_->setLeftInset(kTreeInset);
  setMouseTracking(true);
  setExpandsOnDoubleClick(false);
  setVerticalScrollMode(ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  header()->setStretchLastSection(false);
  header()->setMinimumSectionSize(kRowHeight);
  connect(&Theme::instance(), &Theme::changed, viewport(), qOverload<>(&QWidget::update));
  // If the current row is not visible, the focus frame is drawn around all rows. Scrolling must not
  // move this frame, so the whole view is painted again.
  connect(verticalScrollBar(), &QScrollBar::valueChanged, viewport(),
          qOverload<>(&QWidget::update));
}

void RowView::drawRow(QPainter* painter, const QStyleOptionViewItem& option,
                      const QModelIndex& index) const {
  drawInside([&] { drawGuardedRow(painter, option, index); });
}

/// Catches exceptions of `draw`: an exception must not leave QTreeView::paintEvent(), because the
/// painter would never be ended.
void RowView::drawInside(const std::function<void()>& draw) const {
  auto* view = const_cast<RowView*>(this);
  if (!ExceptionGuard::instance().isCovered(view))
    ExceptionGuard::run(view, ViewWork::kDrawing, draw);
}

void RowView::drawGuardedRow(QPainter* painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) const {
  const bool selected = selectionModel() != nullptr && selectionModel()->isSelected(index);
  const bool hovered =
      option.rect.contains(viewport()->mapFromGlobal(QCursor::pos())) && viewport()->underMouse();
  const Theme& theme = Theme::instance();
  if (selected) {
    painter->fillRect(option.rect, theme.color(Token::kSelection));
  } else if (hovered) {
    painter->fillRect(option.rect, theme.color(Token::kRaised));
  }
  QStyleOptionViewItem plain = option;
  plain.state &= ~(QStyle::State_Selected | QStyle::State_MouseOver);
  plain.showDecorationSelected = false;
  QTreeView::drawRow(painter, plain, index);
}

void RowView::drawBranches(QPainter* painter, const QRect& rect, const QModelIndex& index) const {
  drawInside([&] { QTreeView::drawBranches(painter, rect.translated(kTreeInset, 0), index); });
}

void RowView::paintEvent(QPaintEvent* event) {
  QTreeView::paintEvent(event);
  const QRect row = visualRect(currentIndex().siblingAtColumn(0));
  const bool is_seen = row.intersects(viewport()->rect());
  PaintFocus(*this,
             is_seen ? QRect(0, row.top(), viewport()->width(), row.height()) : viewport()->rect());
  if (empty_text_.isEmpty() || model() == nullptr || model()->rowCount(rootIndex()) > 0) return;
  QPainter painter(viewport());
  painter.setFont(Theme::instance().text());
  painter.setPen(Theme::instance().color(Token::kDim));
  painter.drawText(viewport()->rect().adjusted(kInset, kInset, -kInset, -kInset),
                   static_cast<int>(Qt::AlignHCenter | Qt::AlignTop) | Qt::TextWordWrap,
                   empty_text_);
}

void RowView::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
  QTreeView::currentChanged(current, previous);
  viewport()->update();  // because the focus frame is as wide as the view
}

RowView* MakeRowList(QAbstractItemModel& model, const QString& name, const QString& title,
                     const QString& empty_text) {
  auto* list = new RowView;
  list->setObjectName(name);
  list->setAccessibleName(title);
  list->setRootIsDecorated(false);
  list->setIndentation(0);
  list->rows().setLeftInset(10);
  // A list often shows its end or its current row; the first visible row must not be cut then.
  list->setVerticalScrollMode(QAbstractItemView::ScrollPerItem);
  list->setModel(&model);
  list->setEmptyText(empty_text);
  list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  return list;
}

void FillPage(QWidget& page, QWidget* bar, RowView* list) {
  list->rows().setAllLeft(true);
  list->setSelectionMode(QAbstractItemView::SingleSelection);
  auto* column = new QVBoxLayout(&page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(bar);
  column->addWidget(list, 1);
}

}  // namespace tendon::gui
