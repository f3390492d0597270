#pragma once

#include <gcm_gui/system/plan_activity.h>
#include <gcm_gui/system/plan_controller.h>
#include <gcm_gui/system/system_document.h>
#include <gcm_gui/window/window_parts.h>

#include <QObject>
#include <QString>

class QFileDialog;
class QMenu;

namespace tendon::gui {

class Commands;
class DiffPanel;
class TabPanel;

/// Handles the system file of the window: its menus, its keys, and its tab in the middle.
class SystemFiles : public QObject {
  Q_OBJECT

 public:
  SystemFiles(const WindowParts& parts, TabPanel& centre, QWidget& window);

  void addCommands(Commands& commands);
  [[nodiscard]] SystemDocument& document() { return document_; }
  [[nodiscard]] PlanController& restore() { return restore_; }

  /// Opens a system file and shows the plan that starts the system. The user must confirm the plan.
  void bringUp(const QString& path);
  /// Starts the demo system on the host of the GCM.
  void startDemo();

 Q_SIGNALS:
  /// Emitted with one sentence for the user.
  void notice(const QString& text);
  void titleChanged();

 private:
  void save();
  void saveAs();
  void open();
  void importFile();
  void askForProcess(const QString& file);
  void restoreAll();
  void previewBringUp();
  [[nodiscard]] bool isBringUpInSight() const;
  void carryOutDemo(SystemFile demo);
  void carryOutDemoPlan();
  void showDemo();
  void fillStates(QMenu& menu);
  [[nodiscard]] QFileDialog* makeDialog(const QString& title);
  void showTab();

  LinkState& link_;
  QWidget& window_;
  TabPanel& centre_;
  SystemDocument document_;
  PlanController restore_;
  PlanActivity plans_done_;
  DiffPanel* panel_;
  int page_;
  QString demo_;
  bool starts_demo_ = false;
  bool brings_up_ = false;  // when processes join, show the plan of the file
};

}  // namespace tendon::gui
