#pragma once

#include <gcm_gui/connect/connect_mode.h>
#include <gcm_gui/theme/state_mark.h>

#include <QAbstractItemModel>
#include <QString>
#include <cstddef>
#include <optional>
#include <vector>

namespace tendon::gui {

/// The candidates of the connect mode, best first: those that fit, then those that nearly fit, each
/// with its reasons below it, then the number of others.
class CandidatesModel : public QAbstractItemModel {
  Q_OBJECT

 public:
  explicit CandidatesModel(const ConnectMode& mode, QObject* parent = nullptr);

  /// Further candidates are only counted, until a filter reduces their number.
  static constexpr std::size_t kMostShown = 100;

  /// Shows only candidates whose paths contain all these words, and then also lists the others.
  void setFilter(const QString& words);
  /// The candidate of a row or of its reasons; empty for the row of the others.
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
    StateMark mark = StateMark::kRefused;  // shown in place of the digit
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
