#include <gcm_gui/inspector/values_page.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/views/image_list.h>
#include <gcm_gui/views/row_delegate.h>
#include <gcm_gui/views/row_view.h>

#include <QVBoxLayout>
#include <chrono>

namespace tendon::gui {
namespace {

constexpr std::chrono::milliseconds kTick{250};

}  // namespace

ValuesPage::ValuesPage(Selection& selection, SignalSource& source, QWidget* parent)
    : QWidget(parent), selection_(selection), source_(source), pictures_(new ImageList) {
  list_ = MakeRowList(values_, QStringLiteral("inspector.values"), Words::tr("Values"),
                      Words::tr("This component has no state table."));
  list_->setColumnHidden(ValuesModel::kValue, true);
  list_->rows().setValueColumn(ValuesModel::kValue);
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  connect(&source, &SignalSource::valuesArrived, &values_,
          Guarded(&values_, &ValuesModel::showValues));
  connect(&source, &SignalSource::valuesRefused, &values_,
          Guarded(&values_, &ValuesModel::showRefusal));
  connect(&source, &SignalSource::valuesArrived, pictures_,
          Guarded(pictures_, &ImageList::showValues));
  connect(&values_, &QAbstractItemModel::dataChanged, list_->viewport(),
          [list = list_] { list->viewport()->update(); });
  connect(list_, &QTreeView::clicked, this, &ValuesPage::askAgain);
  connect(list_, &QTreeView::activated, this, &ValuesPage::askAgain);
  connect(list_, &QTreeView::doubleClicked, this, [this](const QModelIndex& index) {
    // A row without a number needs no action, because the first click of the double click has
    // already repeated the request.
    if (!values_.isNumber(index.row())) return;
    Q_EMIT plotRequested(index.data(kPathRole).toString(), values_.unit(index.row()));
  });
  connect(list_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &ValuesPage::publishSelection);
  connect(&tick_, &QTimer::timeout, &values_, Guarded(&values_, &ValuesModel::tick));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(list_, 1);
  column->addWidget(pictures_);
}

void ValuesPage::showComponent(const QString& path, const ComponentDescription& component,
                               StaleReason why) {
  values_.show(path, &component, why);
  pictures_->setColumns(values_.columns());
  pictures_->setStandstill(why);
}

void ValuesPage::setWanted(bool wanted) {
  source_.watch(&values_, wanted ? values_.columns() : QSet<QString>());
  if (!wanted) {
    values_.awaitNothing();
    return tick_.stop();
  }
  values_.await();
  if (!tick_.isActive()) tick_.start(kTick);
}

void ValuesPage::askAgain(const QModelIndex& index) {
  const QString column = values_.askAgain(index.row());
  if (!column.isEmpty()) source_.retry(column);
}

void ValuesPage::publishSelection() {
  QStringList paths;
  for (const QModelIndex& index : list_->selectionModel()->selectedRows()) {
    paths.append(index.data(kPathRole).toString());
  }
  if (!paths.isEmpty()) selection_.setPaths(paths);
}

}  // namespace tendon::gui
