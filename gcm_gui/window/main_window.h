#pragma once

#include <gcm_gui/activity/problems_model.h>
#include <gcm_gui/call/favourites.h>
#include <gcm_gui/connect/connect_mode.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/models/catalogue_filter.h>
#include <gcm_gui/models/connections_model.h>
#include <gcm_gui/models/selection.h>
#include <gcm_gui/window/panels.h>
#include <gcm_gui/window/window_parts.h>

#include <QMainWindow>
#include <QTimer>
#include <cstdint>
#include <vector>

class QSplitter;
class QStackedWidget;

namespace tendon::gui {

class ActivityStrip;
class CandidatePanel;
class CataloguePanel;
class DiagnosisBinding;
class DiagnosisCard;
class GcmLauncher;
class GcmSwitcher;
class GraphCommands;
class GraphScene;
class GraphView;
class Inspector;
class LostBanner;
class MatchCard;
class NoticeLine;
class PlotBinding;
class PlotPanel;
class RecordingOpener;
class RecordingOverlay;
class SystemFiles;
class TabPanel;
class TopBar;
class Tour;
class WindowCommands;
class WindowRecording;
class WindowReplay;

/// The window with a bar at the top, three columns, and a panel at the bottom. It creates the views
/// and connects their signals. The views fill themselves, and WindowCommands assigns the keys.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(WindowParts parts);
  ~MainWindow() override;

  [[nodiscard]] const WindowParts& parts() const { return parts_; }
  [[nodiscard]] Selection& selection() { return selection_; }
  [[nodiscard]] ConnectMode& connectMode() { return mode_; }
  [[nodiscard]] GraphView& graph() const { return *graph_; }
  [[nodiscard]] GraphCommands& graphCommands() const { return *graph_commands_; }
  [[nodiscard]] CataloguePanel& catalogue() const { return *catalogue_; }
  [[nodiscard]] PlotPanel& plots() const { return *plots_; }
  [[nodiscard]] ActivityStrip& strip() const { return *strip_; }
  [[nodiscard]] Inspector& inspector() const { return *inspector_; }
  [[nodiscard]] TopBar& topBar() const { return *top_bar_; }
  [[nodiscard]] CandidatePanel& candidates() const { return *candidates_; }
  [[nodiscard]] SystemFiles& files() const { return *files_; }
  [[nodiscard]] WindowRecording& recording() const { return *recording_; }
  [[nodiscard]] RecordingOpener& opener() const { return *opener_; }
  [[nodiscard]] RecordingOverlay& overlay() const { return *overlay_; }
  /// Null unless the window shows a recording.
  [[nodiscard]] WindowReplay* replay() const { return replay_; }
  [[nodiscard]] TabPanel& centre() const { return *centre_; }
  [[nodiscard]] Tour& tour() const;
  [[nodiscard]] Panels& panels() const { return *panels_; }
  [[nodiscard]] NoticeLine& notice() const { return *notice_; }
  [[nodiscard]] DiagnosisBinding& diagnosis() const { return *why_; }
  [[nodiscard]] GcmSwitcher& gcmSwitcher() const { return *other_; }
  [[nodiscard]] GcmLauncher& gcmLauncher() const { return *gcm_start_; }
  [[nodiscard]] Favourites& favourites() { return favourites_; }
  [[nodiscard]] CatalogueModel& catalogueModel() { return catalogue_model_; }

 public Q_SLOTS:
  void plotSelection();
  /// Starts to connect the selected interface, or the next unconnected interface of the selected
  /// component. If several required interfaces are selected, opens the card that matches all of
  /// them.
  void connectSelection();
  void disconnectSelection();
  /// Shows the form of the selected command.
  void callSelection();
  void revealSelection();
  /// Selects the object of this path, and makes it visible in all views.
  void goTo(const QString& path);
  void escape();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void connectModels();
  /// Reports the views that have thrown an exception.
  void connectExceptionGuard();
  void buildViews();
  [[nodiscard]] QWidget* buildTop();
  [[nodiscard]] QWidget* buildRight();
  [[nodiscard]] QSplitter* buildCentre();
  void buildPanels(QSplitter& centre);
  [[nodiscard]] QWidget* buildGraphPage();
  /// Replaces the graph while there is none.
  [[nodiscard]] QWidget* buildEmptyPage();
  [[nodiscard]] QWidget* buildConnectionsPage();
  void connectViews();
  void connectModeToViews();
  void connectWhy();
  void addFavourites();
  void showPage();
  void showLink();
  void showPerspective(Panels::Perspective perspective);
  void tick();
  [[nodiscard]] std::vector<InterfaceName> selectedRequired() const;
  void startConnecting(const QString& path);
  void pickInConnectMode(const QString& path);

  WindowParts parts_;
  Selection selection_;
  CatalogueModel catalogue_model_;
  CatalogueFilter filter_;
  ConnectionsModel connections_;
  ProblemsModel problems_;
  ConnectMode mode_;
  Favourites favourites_;

  WindowCommands* commands_ = nullptr;
  TopBar* top_bar_ = nullptr;
  LostBanner* lost_ = nullptr;
  WindowRecording* recording_ = nullptr;
  RecordingOpener* opener_ = nullptr;
  RecordingOverlay* overlay_ = nullptr;
  WindowReplay* replay_ = nullptr;
  CataloguePanel* catalogue_ = nullptr;
  GraphScene* scene_ = nullptr;
  GraphView* graph_ = nullptr;
  GraphCommands* graph_commands_ = nullptr;
  QStackedWidget* graph_page_ = nullptr;
  TabPanel* centre_ = nullptr;
  SystemFiles* files_ = nullptr;
  NoticeLine* notice_ = nullptr;
  PlotPanel* plots_ = nullptr;
  PlotBinding* binding_ = nullptr;
  QStackedWidget* right_ = nullptr;
  Inspector* inspector_ = nullptr;
  CandidatePanel* candidates_ = nullptr;
  ActivityStrip* strip_ = nullptr;
  Panels* panels_ = nullptr;
  DiagnosisCard* why_card_ = nullptr;
  DiagnosisBinding* why_ = nullptr;
  MatchCard* match_ = nullptr;
  GcmSwitcher* other_ = nullptr;
  GcmLauncher* gcm_start_ = nullptr;
  QTimer second_;
  // The time when the GCM was lost, ns since 1970; 0 while it is reachable.
  std::int64_t lost_since_ = 0;
};

}  // namespace tendon::gui
