#pragma once

#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/activity/problems_model.h>
#include <gcm_gui/models/selection.h>
#include <gcm_gui/session/system_requests.h>
#include <gcm_gui/views/tab_panel.h>
#include <gcm_gui/window/window_parts.h>

namespace tendon::gui {

class RowView;

class ConsolePage;
class EventsPage;
class LogPage;

/// The bottom panel of the window: the actions so far, with Undo and the equivalent shell command;
/// present problems; log, events and console.
class ActivityStrip : public TabPanel {
  Q_OBJECT

 public:
  ActivityStrip(const WindowParts& parts, ProblemsModel& problems, Selection& selection,
                QWidget* parent = nullptr);

  [[nodiscard]] ConsolePage& console() const { return *console_; }

 public Q_SLOTS:
  void showProblems() { setCurrent(problems_page_); }
  /// Also puts the cursor into its line.
  void showConsole();

 Q_SIGNALS:
  /// The user wants to show `path` in the other views.
  void jumpRequested(const QString& path);
  /// The user clicked a problem or pressed Enter on it; `path` names the thing with the problem.
  void problemChosen(const QString& path);
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  void linkRows(int first, int last);
  void linkRow(int row);
  void showProblemCount(int count);
  void addReports(const WindowParts& parts, Selection& selection);

  ActivityModel& activity_;
  SystemActions& actions_;
  RowView* list_;
  ConsolePage* console_;
  int problems_page_ = 0;
  int console_page_ = 0;
};

}  // namespace tendon::gui
