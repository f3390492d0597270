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

/// The bottom panel of the window. Its tabs show the actions of the user (each with Undo and the
/// equivalent shell command), the present problems, the log, the events and the console.
class ActivityStrip : public TabPanel {
  Q_OBJECT

 public:
  ActivityStrip(const WindowParts& parts, ProblemsModel& problems, Selection& selection,
                QWidget* parent = nullptr);

  /// Must not be called in a window that shows a recording, because that window has no console: the
  /// console commands are for running systems.
  [[nodiscard]] ConsolePage& console() const { return *console_; }

 public Q_SLOTS:
  void showProblems() { setCurrent(problems_page_); }
  /// Shows the console and sets the focus to its input line.
  void showConsole();

 Q_SIGNALS:
  /// Emitted when the user wants to see `path` in the other views.
  void jumpRequested(const QString& path);
  /// Emitted when the user has clicked a problem or pressed Enter on it; `path` names the object
  /// with the problem.
  void problemChosen(const QString& path);
  /// Emitted with one sentence for the user.
  void notice(const QString& text);

 private:
  void linkRows(int first, int last);
  void linkRow(int row);
  void showProblemCount(int count);
  void addReports(const WindowParts& parts, Selection& selection);

  ActivityModel& activity_;
  SystemActions& actions_;
  RowView* list_;
  ConsolePage* console_ = nullptr;
  int problems_page_ = 0;
  int console_page_ = -1;
};

}  // namespace tendon::gui
