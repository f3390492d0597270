#include <gcm_gui/diagnosis/signature_model.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/state_mark.h>

#include <utility>

namespace tendon::gui {
namespace {

using Verdict = SignatureRow::Verdict;

StateMark VerdictMark(Verdict verdict) {
  switch (verdict) {
    case Verdict::kMissing:
    case Verdict::kChanged:
      return StateMark::kRefused;
    case Verdict::kSame:
      return StateMark::kActive;
    case Verdict::kWithout:
    case Verdict::kUnneeded:
      break;
  }
  return StateMark::kNotConnected;
}

/// Returns a remark that fits into a column; the tool tip has the whole difference.
QString ShortRemark(const SignatureRow& row) {
  switch (row.verdict) {
    case Verdict::kSame:
      return Words::tr("same");
    case Verdict::kChanged:
      return row.needed->signature.kind == row.offered->signature.kind ? Words::tr("other type")
                                                                       : Words::tr("other kind");
    default:
      return ToQString(row.remark);
  }
}

}  // namespace

int SignatureModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int SignatureModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumnCount;
}

QVariant SignatureModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kNeeded:
      return Words::tr("Needed");
    case kOffered:
      return Words::tr("Offered");
    default:
      return Words::tr("Difference");
  }
}

SignatureModel::Cell SignatureModel::cellOf(const MemberDescription* member, bool is_event) {
  if (member == nullptr) return {QStringLiteral("–"), {}, QStringLiteral(" ")};
  QString types = ToQString(ToString(member->signature.kind));
  const QString of = TypesText(*member, TypeNames::kShort);
  if (!of.isEmpty()) types += ' ' + of;
  if (member->optional) types += Words::tr(", optional");
  return {ToQString(member->name), types, is_event ? QStringLiteral("⚡") : QStringLiteral("ƒ")};
}

SignatureModel::Row SignatureModel::rowOf(const SignatureRow& row) {
  return {cellOf(row.needed, row.is_event), cellOf(row.offered, row.is_event), ShortRemark(row),
          ToQString(row.remark), row.verdict};
}

void SignatureModel::show(const RequiredDescription& required,
                          const ProvidedDescription& provided) {
  std::vector<Row> fresh;
  for (const auto& row : SignatureDiff(required, provided)) fresh.push_back(rowOf(row));
  if (fresh == rows_) return;
  beginResetModel();
  rows_ = std::move(fresh);
  endResetModel();
}

QVariant SignatureModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = rows_.at(static_cast<std::size_t>(index.row()));
  const bool is_verdict = index.column() == kVerdict;
  const Cell& cell = index.column() == kNeeded ? row.needed : row.offered;
  switch (role) {
    case Qt::DisplayRole:
      return is_verdict ? row.remark : cell.name;
    case Qt::ToolTipRole:
      if (is_verdict) return row.tip;
      return cell.types.isEmpty() ? QString() : cell.name + QStringLiteral(": ") + cell.types;
    case kDetailRole:
      return is_verdict ? QString() : cell.types;
    case kGlyphRole:
      return is_verdict ? QString() : cell.glyph;
    case kGlyphMarkRole:
      return is_verdict ? QVariant::fromValue(VerdictMark(row.verdict)) : QVariant();
    case kStaleRole:
      return row.verdict == Verdict::kUnneeded;
    case Qt::AccessibleTextRole:
      return QStringList{row.needed.name,  row.needed.types,  Words::tr("offered"),
                         row.offered.name, row.offered.types, row.remark,
                         row.tip}
          .join(' ')
          .simplified();
    default:
      return {};
  }
}

}  // namespace tendon::gui
