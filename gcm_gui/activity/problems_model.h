#pragma once

#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/models/row_list_model.h>
#include <gcm_gui/theme/state_mark.h>
#include <tendon/gcm/catalog.h>

#include <QString>
#include <compare>
#include <cstdint>
#include <map>
#include <vector>

namespace tendon::gui {

/// Something that is not as it should be, until it is.
struct Problem {
  QString path;  ///< of what has it
  QString text;
  StateMark mark = StateMark::kWarning;
  std::int64_t since = 0;  ///< ns since 1970; 0 where it is not known

  bool operator==(const Problem&) const = default;
};

/// What is wrong now: lost processes, faulted components, failed connections, and refused requests
/// until the interface is connected after all.
class ProblemsModel : public RowListModel<Problem> {
  Q_OBJECT

 public:
  using RowListModel::RowListModel;

  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

 public Q_SLOTS:
  void update(const tendon::Catalog& catalogue);
  void hear(const tendon::gui::Action& finished);

 Q_SIGNALS:
  void countChanged(int count);

 private:
  void show();
  void dropAnswered(const Catalog& catalogue);

  std::vector<Problem> of_system_;
  std::map<InterfaceName, Problem> refusals_;  // by the required interface
};

}  // namespace tendon::gui
