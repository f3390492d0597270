#pragma once

#include <gcm_gui/diagnosis/signature_diff.h>

#include <QAbstractTableModel>
#include <QString>
#include <vector>

namespace tendon::gui {

/// Shows two interfaces side by side: for each member, the needed member, the offered member, and
/// the difference.
class SignatureModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kNeeded, kOffered, kVerdict, kColumnCount };

  using QAbstractTableModel::QAbstractTableModel;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

  void show(const RequiredDescription& required, const ProvidedDescription& provided);

 private:
  struct Cell {
    QString name;
    QString types;
    QString glyph;
    bool operator==(const Cell&) const = default;
  };
  struct Row {
    Cell needed;
    Cell offered;
    QString remark;
    QString tip;
    SignatureRow::Verdict verdict = SignatureRow::Verdict::kSame;
    bool operator==(const Row&) const = default;
  };
  [[nodiscard]] static Cell cellOf(const MemberDescription* member, bool is_event);
  [[nodiscard]] static Row rowOf(const SignatureRow& row);

  std::vector<Row> rows_;
};

}  // namespace tendon::gui
