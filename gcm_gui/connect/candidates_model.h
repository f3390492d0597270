#pragma once

#include <gcm_gui/connect/connect_mode.h>
#include <gcm_gui/theme/state_mark.h>

#include <QAbstractItemModel>
#include <QString>
#include <cstddef>
#include <optional>
#include <vector>

namespace tendon::gui {

/// The candidates of the connect mode, best first. The ports that fit come first, then the ports
/// that nearly fit. A port that nearly fits has the reasons as child rows. The last row shows the
/// number of all other ports.
class CandidatesModel : public QAbstractItemModel {
  Q_OBJECT

 public:
  explicit CandidatesModel(const ConnectMode& mode, QObject* parent = nullptr);

  /// The maximum number of listed candidates. Further candidates are only counted, until a filter
  /// reduces their number.
  static constexpr std::size_t kMaxShown = 100;

  /// Shows only candidates whose paths contain all these words. With a filter, the ports that do
  /// not fit are listed as well.
  void setFilter(const QString& words);
  /// Returns the candidate of a row or of a reason below it; empty for the row with the number of
  /// other ports.
  [[nodiscard]] std::optional<PortName> portOf(const QModelIndex& index) const;
  [[nodiscard]] bool fits(const QModelIndex& index) const;

  [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent) const override;
  [[nodiscard]] QModelIndex parent(const QModelIndex& index) const override;
  [[nodiscard]] int rowCount(const QModelIndex& parent) const override;
  [[nodiscard]] int columnCount(const QModelIndex&) const override { return 1; }
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

 private:
  struct Row {
    std::optional<PortName> port;
    QString name;
    QString trail;
    QString tip;
    QString digit;
    StateMark mark = StateMark::kRefused;  // shown instead of the digit
    bool fits = false;
    bool stale = false;
    QStringList reasons;

    bool operator==(const Row&) const = default;
  };

  void refresh();
  [[nodiscard]] bool isWanted(const QString& name) const;
  [[nodiscard]] static Row rowOf(const PortCandidate& candidate);
  [[nodiscard]] bool isReason(const QModelIndex& index) const { return index.internalId() > 0; }
  [[nodiscard]] const Row& row(const QModelIndex& index) const;

  const ConnectMode& mode_;
  QStringList words_;
  std::vector<Row> rows_;
};

}  // namespace tendon::gui
