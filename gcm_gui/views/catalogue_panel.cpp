#include <gcm_gui/views/catalogue_panel.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/header_row.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gcm_gui/views/link_button.h>

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <chrono>

namespace tendon::gui {
namespace {

constexpr std::chrono::milliseconds kCountPause{200};
constexpr std::int64_t kUntilFolded = 30'000'000'000;  // ns

}  // namespace

CataloguePanel::CataloguePanel(CatalogueFilter& filter, Selection& selection, SignalSource& source,
                               QWidget* parent)
    : QWidget(parent),
      filter_(filter),
      selection_(selection),
      count_(new QLabel),
      field_(new QLineEdit),
      tree_(new CatalogueTree(filter, selection, source)),
      gone_(MakeLinkButton({}, QStringLiteral("catalogue.gone"))) {
  setObjectName(QStringLiteral("cataloguePanel"));
  setAutoFillBackground(true);
  SetRole(*count_, QStringLiteral("dim"));
  count_->setObjectName(QStringLiteral("catalogueCount"));
  auto* head = new HeaderRow(Words::tr("Catalogue"));
  head->addRight(count_);
  field_->setObjectName(QStringLiteral("filter"));
  field_->setAccessibleName(Words::tr("Filter the catalogue"));
  field_->setPlaceholderText(Words::tr("Filter: arm type:read state:active"));
  field_->setToolTip(
      Words::tr("All words must be in the path; also -word, type:, state:, "
                "proc:, host:, /regex/  (Ctrl+F)"));
  field_->setClearButtonEnabled(true);
  field_->installEventFilter(this);
  auto* around_field = new QVBoxLayout;
  around_field->setContentsMargins(kInset - 2, 2 * kGrid, kInset - 2, 2 * kGrid);
  around_field->addWidget(field_);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(head);
  column->addLayout(around_field);
  column->addWidget(tree_, 1);
  gone_->setCheckable(true);
  gone_->setFocusPolicy(Qt::StrongFocus);
  gone_->setToolTip(Words::tr("Shows or hides processes that have been gone for half a minute"));
  gone_->setVisible(false);
  column->addWidget(gone_, 0, Qt::AlignLeft);

  count_soon_.setSingleShot(true);
  count_soon_.setInterval(kCountPause);
  connect(&count_soon_, &QTimer::timeout, this, Guarded(this, &CataloguePanel::showCount));
  connect(field_, &QLineEdit::textChanged, &filter_, &CatalogueFilter::setText);
  connect(&filter_, &CatalogueFilter::filterApplied, this, &CataloguePanel::showCount);
  connect(&filter_, &CatalogueFilter::filterApplied, this, &CataloguePanel::foldGone);
  connect(&selection, &Selection::changed, this, Guarded(this, &CataloguePanel::showSelected));
  connect(gone_, &QToolButton::toggled, this, &CataloguePanel::foldGone);
  const auto on_rows_changed = [this](const QModelIndex& below) {
    count_soon_.start();
    if (!below.isValid()) foldGone();
  };
  connect(&filter_, &QAbstractItemModel::dataChanged, this,
          [this](const QModelIndex& first, const QModelIndex&, const QList<int>& roles) {
            // A lost process may have returned.
            if (roles.isEmpty() && !first.parent().isValid()) foldGone();
          });
  connect(&filter_, &QAbstractItemModel::rowsInserted, this, on_rows_changed);
  connect(&filter_, &QAbstractItemModel::rowsRemoved, this, on_rows_changed);
  showCount();
}

void CataloguePanel::showCount() {
  // Without a filter, counts items. With a filter, counts rows: a filter also finds numbers below
  // columns, and these are no items.
  const int count = filter_.matchCount();
  const QString items =
      count == 0 ? QString() : CountText(count, Words::tr("%1 item"), Words::tr("%1 items"));
  count_->setText(filter_.active() ? Words::tr("%1 found").arg(count) : items);
  tree_->setEmptyText(filter_.active() ? Words::tr("No row matches the filter.")
                                       : Words::tr("Nothing here yet."));
}

void CataloguePanel::setNow(qint64 now) {
  now_ = now;
  foldGone();
}

/// Returns true if a process must be hidden. A selected process is always shown.
bool CataloguePanel::isFolded(const QModelIndex& process) const {
  const CatalogueItem* item = filter_.item(process);
  if (!item->gone || now_ - item->since < kUntilFolded) return false;
  const QStringList paths = selection_.paths();
  return std::none_of(paths.begin(), paths.end(),
                      [&](const QString& path) { return path.section('/', 0, 0) == item->path; });
}

void CataloguePanel::foldGone() {
  int folded = 0;
  for (int row = 0; row < filter_.rowCount({}); ++row) {
    const bool is_folded = !filter_.active() && isFolded(filter_.index(row, 0, {}));
    if (is_folded) ++folded;
    const bool is_hidden = is_folded && !gone_->isChecked();
    if (tree_->isRowHidden(row, {}) != is_hidden) tree_->setRowHidden(row, {}, is_hidden);
  }
  showFoldedCount(folded);
}

/// Shows the selected process. The process that was selected before stays visible until the next
/// tick, so that no row moves under the pointer.
void CataloguePanel::showSelected() {
  int hidden = 0;
  bool is_shown = false;
  for (int row = 0; row < filter_.rowCount({}); ++row) {
    if (!tree_->isRowHidden(row, {})) continue;
    const bool is_folded = isFolded(filter_.index(row, 0, {}));
    if (is_folded) ++hidden;
    if (!is_folded) tree_->setRowHidden(row, {}, false);
    is_shown = is_shown || !is_folded;
  }
  if (!is_shown) return;
  showFoldedCount(hidden);
  tree_->scrollTo(tree_->currentIndex());
}

void CataloguePanel::showFoldedCount(int folded) {
  gone_->setVisible(folded > 0);
  gone_->setText((gone_->isChecked() ? QStringLiteral("▾ ") : QStringLiteral("▸ ")) +
                 Words::tr("gone (%1)").arg(folded));
}

void CataloguePanel::focusFilter() {
  field_->setFocus(Qt::ShortcutFocusReason);
  field_->selectAll();
}

bool CataloguePanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();  // so that Escape clears the field and triggers no shortcut of the window
    return true;
  }
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Escape) {
      field_->clear();
      filter_.applyText({});
      tree_->setFocus();
      return true;
    }
    if (key == Qt::Key_Down || key == Qt::Key_Return) {
      filter_.applyText(field_->text());
      tree_->setFocus();
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace tendon::gui
