#pragma once

#include <gcm_gui/activity/problems_model.h>
#include <gcm_gui/graph/connect_mode.h>
#include <gcm_gui/models/catalogue_filter.h>
#include <gcm_gui/models/connections_model.h>
#include <gcm_gui/models/selection.h>
#include <gcm_gui/window/window_parts.h>

#include <QMainWindow>
#include <QTimer>

class QStackedWidget;

namespace tendon::gui {

class ActivityStrip;
class CataloguePanel;
class GraphScene;
class GraphView;
class Inspector;
class NoticeLine;
class PlotBinding;
class PlotPanel;
class TabPanel;
class TopBar;

/// The window: a bar, three columns, a strip. It puts the views together and gives them their keys;
/// what they show they know themselves.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(WindowParts parts);
  ~MainWindow() override;

  [[nodiscard]] const WindowParts& parts() const { return parts_; }
  [[nodiscard]] Selection& selection() { return selection_; }
  [[nodiscard]] ConnectMode& connectMode() { return mode_; }
  [[nodiscard]] GraphView& graph() const { return *graph_; }
  [[nodiscard]] CataloguePanel& catalogue() const { return *catalogue_; }
  [[nodiscard]] PlotPanel& plots() const { return *plots_; }
  [[nodiscard]] ActivityStrip& strip() const { return *strip_; }
  [[nodiscard]] Inspector& inspector() const { return *inspector_; }
  [[nodiscard]] TopBar& topBar() const { return *top_bar_; }
  [[nodiscard]] CatalogueModel& catalogueModel() { return catalogue_model_; }

 public Q_SLOTS:
  void plotSelection();
  /// Begins with the selected interface, or with the next unconnected one of the component.
  void connectSelection();
  void disconnectSelection();
  void revealSelection();
  void escape();

 private:
  void connectModels();
  void buildViews();
  [[nodiscard]] QWidget* buildCentre();
  [[nodiscard]] QWidget* buildGraphPage();
  [[nodiscard]] QWidget* buildConnectionsPage();
  void connectViews();
  void addKey(const QKeySequence& key, const QString& name, void (MainWindow::*slot)());
  void addKeys();
  void showPage();
  void tick();
  void startConnecting(const QString& path);
  void pickInConnectMode(const QString& path);

  WindowParts parts_;
  Selection selection_;
  CatalogueModel catalogue_model_;
  CatalogueFilter filter_;
  ConnectionsModel connections_;
  ProblemsModel problems_;
  ConnectMode mode_;

  TopBar* top_bar_ = nullptr;
  CataloguePanel* catalogue_ = nullptr;
  GraphScene* scene_ = nullptr;
  GraphView* graph_ = nullptr;
  QStackedWidget* graph_page_ = nullptr;
  TabPanel* centre_ = nullptr;
  NoticeLine* notice_ = nullptr;
  PlotPanel* plots_ = nullptr;
  PlotBinding* binding_ = nullptr;
  Inspector* inspector_ = nullptr;
  ActivityStrip* strip_ = nullptr;
  QTimer second_;
};

}  // namespace tendon::gui
