#pragma once

#include <gcm_gui/inspector/configuration_model.h>
#include <gcm_gui/inspector/cycle_figures.h>
#include <gcm_gui/inspector/health_figures.h>
#include <gcm_gui/inspector/interfaces_model.h>
#include <gcm_gui/models/selection.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/signal_source.h>
#include <gcm_gui/session/system_requests.h>

#include <QTimer>
#include <QWidget>

class QLabel;
class QPushButton;
class QStackedWidget;

namespace tendon::gui {

class CallPanel;
class EventList;
class PropertyGrid;
class RowView;
class StateLabel;
class LifecycleRow;
class TabPanel;
class ValuesPage;

/// The right column. Shows everything about the selected process or component. If another object is
/// selected, shows the component that contains the object. Follows the selection and the catalogue.
class Inspector : public QWidget {
  Q_OBJECT

 public:
  Inspector(const CatalogueStore& store, Selection& selection, SignalSource& source,
            SystemActions& actions, CommandCalls& calls, SystemReports& reports,
            QWidget* parent = nullptr);

  /// Sets the focus to the argument of the selected command; returns false if none is selected.
  bool focusCall();

 public Q_SLOTS:
  /// Pass true while the link to the GCM is lost. States and connections are then unknown, but
  /// values are still updated.
  void setOutdated(bool outdated);

 Q_SIGNALS:
  void plotRequested(const QString& path, const QString& unit);
  /// Emitted when the user wants another provider for a required interface that is connected.
  void connectRequested(const QString& path);
  /// Emitted when the user asks why a required interface is connected or not.
  void whyRequested(const QString& path);
  void favouriteRequested(const QString& path, const QString& argument);
  /// Emitted with one sentence for the user.
  void notice(const QString& text);

 private:
  QWidget* buildHead();
  QWidget* buildComponentPage();
  QWidget* buildProcessPage();
  QWidget* buildInterfaces();
  QWidget* buildThread();
  RowView* buildConfiguration();
  void showHealth();
  void showProcessFacts();
  void refresh();
  void showSelected();
  void showTabOfSelected();
  void showComponent(const ProcessEntry& process, const ComponentDescription& component);
  void showProcess(const ProcessEntry& process);
  /// Shows the form of the selected command, if a command is selected.
  void showCall(const ProcessEntry& process, const ComponentDescription& component);
  void showNothing(const QString& text);
  void showFigures();
  void watchValues();
  void addLinks(int first, int last);
  [[nodiscard]] QWidget* makeLinks(const InterfaceRow& row);
  void addPeerLinks(QWidget& cell, const InterfaceRow& peer);

  const CatalogueStore& store_;
  Selection& selection_;
  SystemActions& actions_;
  InterfacesModel interfaces_;
  ConfigurationModel configuration_;
  CycleFigures figures_;
  HealthFigures health_;
  QTimer figures_timer_;

  QLabel* name_;
  StateLabel* state_;
  QLabel* process_;
  PropertyGrid* component_facts_;
  PropertyGrid* thread_facts_ = nullptr;
  LifecycleRow* lifecycle_;
  PropertyGrid* process_facts_;
  QPushButton* forget_;
  QLabel* nothing_;
  RowView* interface_list_;
  CallPanel* call_;
  EventList* events_;
  ValuesPage* values_;
  TabPanel* tabs_;
  QStackedWidget* pages_;
  int interfaces_page_ = 0;
  int values_page_ = 0;
  int events_page_ = 0;
  QString shown_component_;
  double wanted_period_ = 0;  // s; the period from the configuration
};

}  // namespace tendon::gui
