#pragma once

#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/models/row_list_model.h>
#include <gcm_gui/theme/state_mark.h>
#include <tendon/gcm/catalogue.h>

#include <QString>
#include <compare>
#include <cstdint>
#include <map>
#include <vector>

namespace tendon::gui {

/// A problem; it is listed until it is solved.
struct ListedProblem {
  QString path;  ///< of the object with the problem; empty for a view of the window
  QString text;
  StateMark mark = StateMark::kWarning;
  std::int64_t since = 0;  ///< ns since 1970; 0 if unknown
  QString time{};          ///< of the day; spaces of this length to align with another problem

  bool operator==(const ListedProblem&) const = default;
};

/// The present problems: lost processes; plug-ins whose files differ from the running code;
/// components that are faulted or wait for a connection; failed connections; refused connections,
/// until they are established; views of this window that have thrown an exception. Warnings come
/// last.
class ProblemsModel : public RowListModel<ListedProblem> {
  Q_OBJECT

 public:
  using RowListModel::RowListModel;

  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

 public Q_SLOTS:
  void update(const tendon::Catalogue& catalogue);
  void onActionFinished(const tendon::gui::Action& finished);
  void showFaults(const QList<tendon::gui::ViewFault>& faults);

 Q_SIGNALS:
  void countChanged(int count);

 private:
  void show();
  void dropRecovered(const Catalogue& catalogue);

  std::vector<ListedProblem> of_system_;
  std::map<InterfaceName, ListedProblem> refusals_;  // by the required interface
  QList<ViewFault> faults_;
  std::vector<ListedProblem> of_views_;  // from faults_
};

}  // namespace tendon::gui
