#pragma once

#include <gcm_gui/activity/problems_model.h>
#include <gcm_gui/call/favourites/favourites.h>
#include <gcm_gui/connect/connect_mode.h>
#include <gcm_gui/fence/fence.h>
#include <gcm_gui/models/connections_model.h>
#include <gcm_gui/models/filter/catalogue_filter.h>
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
class CommandPalette;
class Commands;
class GcmStart;
class GraphCommands;
class GraphScene;
class GraphView;
class Inspector;
class KeysCard;
class LostBanner;
class MatchCard;
class NoticeLine;
class OtherGcm;
class PlotBinding;
class PlotPanel;
class Redo;
class SteerCommands;
class SystemFiles;
class TabPanel;
class TopBar;
class Tour;
class WhyBinding;
class WhyCard;

/// The window: a bar, three columns, a strip. It creates the views, connects them and assigns keys;
/// the views themselves know their contents.
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
  [[nodiscard]] TabPanel& centre() const { return *centre_; }
  [[nodiscard]] Tour& tour() const { return *tour_; }
  [[nodiscard]] Panels& panels() const { return *panels_; }
  [[nodiscard]] Favourites& favourites() { return favourites_; }
  [[nodiscard]] CatalogueModel& catalogueModel() { return catalogue_model_; }

 public Q_SLOTS:
  void plotSelection();
  /// Begins a connection of the selected interface, or of the next unconnected one of the
  /// component. If several required ones are selected, matches all of them.
  void connectSelection();
  void disconnectSelection();
  /// Goes to the form of the selected command.
  void callSelection();
  void revealSelection();
  /// Selects the object and makes it visible in all views.
  void goTo(const QString& path);
  void escape();

 private:
  void connectModels();
  /// Reports views that have thrown.
  void connectFence();
  void buildViews();
  [[nodiscard]] QWidget* buildTop();
  [[nodiscard]] QWidget* buildRight();
  [[nodiscard]] QSplitter* buildCentre();
  void buildPanels(QSplitter& centre);
  [[nodiscard]] QWidget* buildGraphPage();
  [[nodiscard]] QWidget* buildConnectionsPage();
  void connectViews();
  void connectModeToViews();
  void connectWhy();
  void addFavourites();
  void addCommands();
  void addSystemCommands();
  void addSteerCommands();
  void addPlotCommands();
  void addHelpCommands();
  void addPalette();
  void forbidChanges();
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

  Commands* commands_ = nullptr;
  CommandPalette* palette_ = nullptr;
  TopBar* top_bar_ = nullptr;
  LostBanner* lost_ = nullptr;
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
  WhyCard* why_card_ = nullptr;
  WhyBinding* why_ = nullptr;
  MatchCard* match_ = nullptr;
  SteerCommands* steer_ = nullptr;
  Redo* redo_ = nullptr;
  OtherGcm* other_ = nullptr;
  GcmStart* gcm_start_ = nullptr;
  KeysCard* keys_ = nullptr;
  Tour* tour_ = nullptr;
  QTimer second_;
  std::int64_t lost_since_ = 0;  // loss of the GCM, ns since 1970; 0 while it is reachable
};

}  // namespace tendon::gui
