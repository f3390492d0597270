#include <gcm_gui/views/catalogue_tree.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/views/catalogue_columns.h>

#include <QContextMenuEvent>
#include <QScopedValueRollback>
#include <chrono>

namespace tendon::gui {
namespace {

constexpr std::chrono::milliseconds kSettle{50};
constexpr int kMaxExpanded = 200;  // maximum number of rows that a filter expands by itself

}  // namespace

CatalogueTree::CatalogueTree(CatalogueFilter& filter, Selection& selection, SignalSource& source,
                             QWidget* parent)
    : RowView(parent), filter_(filter), selection_(selection), source_(source) {
  setObjectName(QStringLiteral("catalogue"));
  setAccessibleName(Words::tr("Catalogue"));
  setSelectionMode(ExtendedSelection);
  setDragEnabled(true);
  setDragDropMode(DragOnly);
  // Must be connected before the selection model, so that the paths of removed rows stay selected.
  connect(&filter, &QAbstractItemModel::rowsAboutToBeRemoved, this, [this] { removing_ = true; });
  setModel(&filter);
  columns_ = new CatalogueColumns(*this);
  settle_.setSingleShot(true);
  settle_.setInterval(kSettle);
  connect(&settle_, &QTimer::timeout, this, Guarded(this, &CatalogueTree::watchVisible));
  connectModel();
  restore({}, 0, filter.rowCount({}) - 1);
}

void CatalogueTree::connectModel() {
  connect(model(), &QAbstractItemModel::rowsInserted, this,
          [this](const QModelIndex& parent, int first, int last) {
            restore(parent, first, last);
            showSelection();
            settle_.start();
          });
  connect(model(), &QAbstractItemModel::rowsRemoved, this, [this] {
    removing_ = false;
    settle_.start();
  });
  connect(model(), &QAbstractItemModel::dataChanged, this,
          [this](const QModelIndex&, const QModelIndex&, const QList<int>& roles) {
            viewport()->update();
            // A signal without roles means that not only values have changed: rows may have
            // returned with a lost process.
            if (roles.isEmpty()) settle_.start();
          });
  connect(&filter_, &CatalogueFilter::filterApplied, this, &CatalogueTree::applyFilter);
  connect(&selection_, &Selection::changed, this, Guarded(this, &CatalogueTree::showSelection));
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &CatalogueTree::publishSelection);
  connect(this, &QTreeView::doubleClicked, this, &CatalogueTree::activateRow);
  connect(this, &QTreeView::expanded, this, [this](const QModelIndex& i) { remember(i, true); });
  connect(this, &QTreeView::collapsed, this, [this](const QModelIndex& i) { remember(i, false); });
}

void CatalogueTree::ExpandedRows::note(const QString& path, bool open) {
  (open ? expanded : collapsed).insert(path);
  (open ? collapsed : expanded).remove(path);
}

void CatalogueTree::remember(const QModelIndex& index, bool open) {
  settle_.start();
  if (restoring_) return;
  const QString path = index.data(kPathRole).toString();
  if (filtered_) filtered_->note(path, open);
  if (!filtered_ || open) own_.note(path, open);
}

void CatalogueTree::restore(const QModelIndex& parent, int first, int last) {
  const QScopedValueRollback guard(restoring_, true);
  const ExpandedRows& known = filtered_ ? *filtered_ : own_;
  for (int row = first; row <= last; ++row) {
    const QModelIndex index = model()->index(row, 0, parent);
    const QString path = index.data(kPathRole).toString();
    const bool is_process = index.data(kKindRole).toInt() == static_cast<int>(ItemKind::kProcess);
    if (is_process && !known.collapsed.contains(path)) setExpanded(index, true);
    for (const QString& open : known.expanded) {
      if (open.startsWith(path)) setExpanded(filter_.indexOf(open), true);
    }
  }
}

void CatalogueTree::applyFilter() {
  const QScopedValueRollback guard(restoring_, true);
  if (!filter_.active()) {
    filtered_.reset();
  } else if (!filtered_) {
    filtered_ = own_;
  }
  if (filter_.active() && filter_.matchCount() <= kMaxExpanded) expandToDepth(3);
  restore({}, 0, filter_.rowCount({}) - 1);
  showSelection();
  if (!filter_.active()) scrollTo(currentIndex());
  settle_.start();
}

/// Opens no menu on an empty part of the view, because no selected item is under the pointer there.
void CatalogueTree::contextMenuEvent(QContextMenuEvent* event) {
  const bool is_by_key = event->reason() == QContextMenuEvent::Keyboard;
  if (!is_by_key && !indexAt(event->pos()).isValid()) return;
  const QRect current = visualRect(currentIndex());
  Q_EMIT menuRequested(is_by_key ? viewport()->mapToGlobal(current.bottomLeft())
                                 : event->globalPos());
}

void CatalogueTree::activateRow(const QModelIndex& index) {
  const CatalogueItem* item = filter_.item(index);
  if (item == nullptr) return;
  if (item->kind >= ItemKind::kColumn) {
    Q_EMIT plotRequested(item->path);
  } else if (item->kind == ItemKind::kRequired || item->kind == ItemKind::kProvided) {
    Q_EMIT connectRequested(item->path);
  } else {
    setExpanded(index, !isExpanded(index));
  }
}

void CatalogueTree::publishSelection() {
  if (publishing_ || removing_) return;
  const QScopedValueRollback guard(publishing_, true);
  QStringList paths;
  for (const QModelIndex& index : selectionModel()->selectedRows()) {
    paths.append(index.data(kPathRole).toString());
  }
  // The row that was clicked last becomes the current one.
  const QString current = currentIndex().data(kPathRole).toString();
  if (paths.removeOne(current)) paths.append(current);
  selection_.setPaths(paths);
}

void CatalogueTree::showSelection() {
  if (publishing_) return;
  const QScopedValueRollback guard(publishing_, true);
  QItemSelection rows;
  for (const QString& path : selection_.paths()) {
    const QModelIndex index = filter_.indexOf(path);
    if (index.isValid()) rows.select(index, index);
  }
  selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  const QModelIndex current = filter_.indexOf(selection_.current());
  if (current.isValid()) {
    selectionModel()->setCurrentIndex(current, QItemSelectionModel::NoUpdate);
  }
}

void CatalogueTree::reveal(const QString& path) {
  const QModelIndex index = filter_.indexOf(path);
  if (!index.isValid()) return;
  for (QModelIndex above = index.parent(); above.isValid(); above = above.parent()) expand(above);
  scrollTo(index);
}

QHash<QString, QRect> CatalogueTree::visibleRows() const {
  QHash<QString, QRect> rows;
  QModelIndex index = indexAt({1, 1});
  while (index.isValid()) {
    const QRect rect = visualRect(index);
    if (rect.top() >= viewport()->height()) break;
    rows.insert(index.data(kPathRole).toString(), rect);
    index = indexBelow(index);
  }
  return rows;
}

void CatalogueTree::watchVisible() {
  QSet<QString> columns;
  QModelIndex index = isVisible() ? indexAt({1, 1}) : QModelIndex();
  while (index.isValid() && visualRect(index).top() < viewport()->height()) {
    const CatalogueItem* item = filter_.item(index);
    if (item->kind >= ItemKind::kColumn && !item->gone) {
      columns.insert(filter_.catalogue().columnOf(filter_.mapToSource(index)));
    }
    index = indexBelow(index);
  }
  filter_.catalogue().setWatched(columns);
  source_.watch(this, columns);
}

void CatalogueTree::resizeEvent(QResizeEvent* event) {
  RowView::resizeEvent(event);
  settle_.start();
}

void CatalogueTree::showEvent(QShowEvent* event) {
  RowView::showEvent(event);
  settle_.start();
}

void CatalogueTree::hideEvent(QHideEvent* event) {
  RowView::hideEvent(event);
  settle_.start();
}

void CatalogueTree::scrollContentsBy(int dx, int dy) {
  RowView::scrollContentsBy(dx, dy);
  settle_.start();
}

}  // namespace tendon::gui
