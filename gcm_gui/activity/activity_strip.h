#pragma once

#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/activity/problems_model.h>
#include <gcm_gui/models/selection.h>
#include <gcm_gui/session/system_actions.h>
#include <gcm_gui/views/tab_panel.h>

namespace tendon::gui {

class RowView;

/// The bottom of the window: what was done, with a way back and the line that does the same in a
/// terminal; and what is wrong now.
class ActivityStrip : public TabPanel {
  Q_OBJECT

 public:
  ActivityStrip(ActivityModel& activity, ProblemsModel& problems, SystemActions& actions,
                Selection& selection, QWidget* parent = nullptr);

 public Q_SLOTS:
  void showProblems() { setCurrent(problems_page_); }

 Q_SIGNALS:
  /// A row of the problems was clicked, or chosen with Enter: of what is wrong there.
  void problemChosen(const QString& path);

 private:
  void linkRows(int first, int last);
  void linkRow(int row);
  void showProblemCount(int count);

  ActivityModel& activity_;
  SystemActions& actions_;
  RowView* list_;
  int problems_page_ = 0;
};

}  // namespace tendon::gui
