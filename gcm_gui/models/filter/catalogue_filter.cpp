#include <gcm_gui/models/filter/catalogue_filter.h>

#include <algorithm>
#include <chrono>

namespace tendon::gui {
namespace {

constexpr std::chrono::milliseconds kTypingPause{120};

int CountMatches(const FilterExpression& expression, const CatalogueModel& model,
                 const QModelIndex& parent) {
  int count = 0;
  for (int row = 0; row < model.rowCount(parent); ++row) {
    const QModelIndex index = model.index(row, 0, parent);
    if (expression.Matches(*model.item(index))) ++count;
    count += CountMatches(expression, model, index);
  }
  return count;
}

}  // namespace

CatalogueFilter::CatalogueFilter(CatalogueModel& model, QObject* parent)
    : QSortFilterProxyModel(parent), model_(model) {
  setRecursiveFilteringEnabled(true);
  setSourceModel(&model);
  typing_.setSingleShot(true);
  typing_.setInterval(kTypingPause);
  connect(&typing_, &QTimer::timeout, this, [this] { applyText(pending_); });
}

int CatalogueFilter::matchCount() const {
  return active() ? CountMatches(expression_, model_, {}) : model_.itemCount();
}

QModelIndex CatalogueFilter::indexOf(const QString& path) const {
  return mapFromSource(model_.indexOf(path));
}

const CatalogueItem* CatalogueFilter::item(const QModelIndex& index) const {
  return model_.item(mapToSource(index));
}

void CatalogueFilter::setText(const QString& text) {
  pending_ = text;
  typing_.start();
}

void CatalogueFilter::applyText(const QString& text) {
  typing_.stop();
  pending_ = text;
  expression_ = FilterExpression(text);
  invalidateFilter();
  Q_EMIT filterApplied();
}

bool CatalogueFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  if (expression_.empty()) return true;
  return expression_.Matches(*model_.item(model_.index(row, 0, parent)));
}

}  // namespace tendon::gui
