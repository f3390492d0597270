#pragma once

#include <QAbstractListModel>
#include <cstddef>
#include <utility>
#include <vector>

namespace tendon::gui {

/// A flat list that is always replaced as a whole. The rows before the first difference are not
/// touched, so views keep them.
template <typename Row>
class RowListModel : public QAbstractListModel {
 public:
  using QAbstractListModel::QAbstractListModel;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
  }
  [[nodiscard]] const Row& row(int row) const { return rows_.at(static_cast<std::size_t>(row)); }

 protected:
  void showRows(std::vector<Row> fresh) {
    std::size_t same = 0;
    while (same < rows_.size() && same < fresh.size() && rows_[same] == fresh[same]) ++same;
    if (same < rows_.size()) {
      beginRemoveRows({}, static_cast<int>(same), static_cast<int>(rows_.size()) - 1);
      rows_.resize(same);
      endRemoveRows();
    }
    if (same < fresh.size()) {
      beginInsertRows({}, static_cast<int>(same), static_cast<int>(fresh.size()) - 1);
      rows_ = std::move(fresh);
      endInsertRows();
    }
  }

 private:
  std::vector<Row> rows_;
};

}  // namespace tendon::gui
