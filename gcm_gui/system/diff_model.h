#pragma once

#include <gcm_gui/models/row_list_model.h>
#include <gcm_gui/system/plan_controller.h>
#include <tendon/gcm/system/comparison.h>

#include <QString>

namespace tendon::gui {

/// The differences between the running system and its file.
class DiffModel : public RowListModel<SystemDifference> {
  Q_OBJECT

 public:
  using RowListModel::RowListModel;

  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  void show(const SystemComparison& comparison) { showRows(comparison.differences); }
};

/// Returns the summary: "= 29   + 2 only running   − 1 missing   ~ 1 changed".
[[nodiscard]] QString SummaryOf(const SystemComparison& comparison);

/// A line of a plan: a step with its result, or a part of the goal that no step can reach.
struct PlanLine {
  enum class Kind { kObstacle, kNote, kWaiting, kDone, kFailed, kLeft };

  Kind kind = Kind::kWaiting;
  QString text;
  QString trail;

  bool operator==(const PlanLine&) const = default;
};

/// A plan: first its obstacles and remarks, then its steps in order.
class PlanModel : public RowListModel<PlanLine> {
  Q_OBJECT

 public:
  using RowListModel::RowListModel;

  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  void show(const PlanController& restore);
};

}  // namespace tendon::gui
