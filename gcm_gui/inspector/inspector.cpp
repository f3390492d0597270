#include <gcm_gui/inspector/inspector.h>

#include <gcm_gui/call/call_panel.h>
#include <gcm_gui/call/hold_button.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/inspector/event_list.h>
#include <gcm_gui/inspector/thread_facts.h>
#include <gcm_gui/inspector/values_page.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/lifecycle/lifecycle_row.h>
#include <gcm_gui/models/plugin_words.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/header_row.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/link_button.h>
#include <gcm_gui/views/property_grid.h>
#include <gcm_gui/views/row_delegate.h>
#include <gcm_gui/views/row_view.h>
#include <gcm_gui/views/state_label.h>
#include <gcm_gui/views/tab_panel.h>
#include <tendon/base/path.h>
#include <tendon/base/text.h>
#include <tendon/gcm/initial_arguments.h>
#include <tendon/gcm/text.h>
#include <tendon/gcm/waiting.h>

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <chrono>

namespace tendon::gui {
namespace {

constexpr std::chrono::milliseconds kFiguresPeriod{250};
enum Page { kNothingPage, kProcessPage, kComponentPage };

/// Returns the file of a running plug-in, and how this file differs from the running code.
QList<Property> PluginFacts(const ProcessDescription& process, const std::string& library) {
  const auto* plugin = FindNamed(process.plugins, library);
  if (plugin == nullptr) return {};
  const QString file = ToQString(plugin->file);
  QList<Property> facts{{Words::tr("Plug-in"), file.section('/', -1), file},
                        {Words::tr("Written"), ToQString(WallTimeText(plugin->written)), file}};
  if (const QString change = PluginChangeWords(*plugin); !change.isEmpty()) {
    facts.append({Words::tr("File has changed"), change, {}, Property::Kind::kSentence});
  }
  return facts;
}

bool HasCycle(const ComponentDescription& component) {
  return std::any_of(component.tables.begin(), component.tables.end(), [](const auto& table) {
    return table.name == "state" && std::any_of(table.columns.begin(), table.columns.end(),
                                                [](const auto& c) { return c.name == "Cycle"; });
  });
}

}  // namespace

Inspector::Inspector(const CatalogueStore& store, Selection& selection, SignalSource& source,
                     SystemActions& actions, CommandCalls& calls, SystemReports& reports,
                     QWidget* parent)
    : QWidget(parent),
      store_(store),
      selection_(selection),
      actions_(actions),
      figures_(source),
      health_(reports, store),
      call_(new CallPanel(calls)),
      events_(new EventList(reports)),
      values_(new ValuesPage(selection, source)) {
  setObjectName(QStringLiteral("inspector"));
  setAccessibleName(Words::tr("Inspector"));
  setAutoFillBackground(true);
  nothing_ = new QLabel;
  nothing_->setWordWrap(true);
  nothing_->setAlignment(Qt::AlignTop);
  nothing_->setMargin(kInset);
  SetRole(*nothing_, QStringLiteral("dim"));
  pages_ = new QStackedWidget;
  pages_->addWidget(nothing_);
  pages_->addWidget(buildProcessPage());
  pages_->addWidget(buildComponentPage());
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(buildHead());
  column->addWidget(pages_, 1);

  connect(&store, &CatalogueStore::changed, this, Guarded(this, &Inspector::refresh));
  connect(&selection, &Selection::changed, this, Guarded(this, &Inspector::showSelected));
  connect(values_, &ValuesPage::plotRequested, this, &Inspector::plotRequested);
  connect(&figures_timer_, &QTimer::timeout, this, Guarded(this, &Inspector::showFigures));
  connect(call_, &CallPanel::favouriteRequested, this, &Inspector::favouriteRequested);
  connect(&health_, &HealthFigures::changed, this, &Inspector::showHealth);
  figures_timer_.start(kFiguresPeriod);
  refresh();
}

QWidget* Inspector::buildHead() {
  auto* head = new HeaderRow;
  name_ = new QLabel;
  name_->setObjectName(QStringLiteral("inspector.name"));
  SetRole(*name_, QStringLiteral("strong"));
  state_ = new StateLabel;
  process_ = new QLabel;
  SetRole(*process_, QStringLiteral("dim mono"));
  head->addLeft(name_);
  head->addLeft(state_);
  head->addRight(process_);
  return head;
}

QWidget* Inspector::buildProcessPage() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  process_facts_ = new PropertyGrid;
  forget_ = new QPushButton(Words::tr("Forget this process"));
  forget_->setObjectName(QStringLiteral("forget"));
  forget_->setProperty("changesSystem", true);
  forget_->setToolTip(Words::tr("Removes the process and its last state from the catalogue"));
  connect(forget_, &QPushButton::clicked, this,
          [this] { actions_.forget(selection_.current().toStdString()); });
  auto* line = new QHBoxLayout;
  line->setContentsMargins(kInset, 0, kInset, 0);
  line->addWidget(forget_);
  line->addStretch();
  column->addWidget(process_facts_);
  column->addLayout(line);
  column->addStretch();
  return page;
}

QWidget* Inspector::buildComponentPage() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  component_facts_ = new PropertyGrid;
  lifecycle_ = new LifecycleRow;
  connect(lifecycle_, &LifecycleRow::notice, this, &Inspector::notice);
  connect(lifecycle_, &LifecycleRow::chosen, this, [this](LifecycleVerb verb) {
    if (const auto path = ParsePath(shown_component_.toStdString()); path.ok()) {
      actions_.executeLifecycleOrder(verb, path->process, path->component);
    }
  });
  tabs_ = new TabPanel(QStringLiteral("inspectorTabs"));
  interfaces_page_ = tabs_->addPage(buildInterfaces(), Words::tr("Interfaces"));
  values_page_ = tabs_->addPage(values_, Words::tr("Values"));
  events_page_ = tabs_->addPage(events_, Words::tr("Events"));
  tabs_->addPage(buildThread(), Words::tr("Thread"));
  tabs_->addPage(buildConfiguration(), Words::tr("Config"));
  connect(tabs_, &TabPanel::currentChanged, this, &Inspector::watchValues);
  ExceptionGuard::setName(*this, Words::tr("Inspector"));
  ExceptionGuard::setName(*values_, Words::tr("Inspector: values"));
  ExceptionGuard::setName(*events_, Words::tr("Inspector: events"));
  ExceptionGuard::setName(*call_, Words::tr("Inspector: call"));
  column->addWidget(component_facts_);
  column->addWidget(lifecycle_);
  column->addWidget(tabs_, 1);
  return page;
}

QWidget* Inspector::buildInterfaces() {
  interface_list_ =
      MakeRowList(interfaces_, QStringLiteral("inspector.interfaces"), Words::tr("Interfaces"),
                  Words::tr("This component has no interfaces."));
  connect(interface_list_, &QTreeView::clicked, this, [this](const QModelIndex& index) {
    if (interfaces_.row(index.row()).kind == InterfaceRow::Kind::kPeer) return;
    selection_.select(index.data(kPathRole).toString());
  });
  connect(&interfaces_, &QAbstractItemModel::rowsInserted, this,
          [this](const QModelIndex&, int first, int last) { addLinks(first, last); });
  connect(interface_list_, &QTreeView::activated, this, [this](const QModelIndex& index) {
    if (interfaces_.row(index.row()).kind != InterfaceRow::Kind::kMember) return;
    selection_.select(index.data(kPathRole).toString());
    focusCall();
  });
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(interface_list_, 1);
  column->addWidget(call_);
  return page;
}

QWidget* Inspector::buildThread() {
  thread_facts_ = new PropertyGrid;
  thread_facts_->setObjectName(QStringLiteral("inspector.thread"));
  auto* page = new QScrollArea;
  page->setFrameShape(QFrame::NoFrame);
  page->setWidgetResizable(true);
  page->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  page->setAccessibleName(Words::tr("Thread"));
  auto* around = new QWidget;
  auto* column = new QVBoxLayout(around);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(thread_facts_);
  column->addStretch();
  page->setWidget(around);
  return page;
}

RowView* Inspector::buildConfiguration() {
  RowView* list = MakeRowList(configuration_, QStringLiteral("inspector.configuration"),
                              Words::tr("Config"), {});
  list->rows().setAllLeft(true);
  return list;
}

void Inspector::addLinks(int first, int last) {
  QWidget* before = interface_list_;
  for (int row = first; row <= last; ++row) {
    const InterfaceRow::Kind kind = interfaces_.row(row).kind;
    if (kind != InterfaceRow::Kind::kPeer && kind != InterfaceRow::Kind::kRequired) continue;
    QWidget* links = makeLinks(interfaces_.row(row));
    interface_list_->setIndexWidget(interfaces_.index(row), links);
    for (auto* link : links->findChildren<QToolButton*>()) {
      setTabOrder(before, link);
      before = link;
    }
  }
}

QWidget* Inspector::makeLinks(const InterfaceRow& row) {
  auto* cell = new QWidget;
  auto* line = new QHBoxLayout(cell);
  line->setContentsMargins(0, 0, kInset - 6, 0);
  line->setSpacing(0);
  line->addStretch();
  if (row.kind == InterfaceRow::Kind::kPeer) {
    addPeerLinks(*cell, row);
    return cell;
  }
  QToolButton* why = MakeLinkButton(Words::tr("Why?"), QStringLiteral("why"));
  why->setAccessibleName(Words::tr("Why is ") + row.path + QStringLiteral(" ") + row.value);
  line->addWidget(why);
  connect(why, &QToolButton::clicked, this, [this, path = row.path] { Q_EMIT whyRequested(path); });
  return cell;
}

void Inspector::addPeerLinks(QWidget& cell, const InterfaceRow& peer) {
  const QString required = ToQString(ToString(peer.required));
  const auto add = [&](const QString& word, const QString& name) {
    QToolButton* button = MakeLinkButton(word, name);
    button->setAccessibleName(word + ' ' + required);
    button->setProperty("changesSystem", true);
    cell.layout()->addWidget(button);
    return button;
  };
  if (peer.path != required) {  // the row shows the provider, so the user can replace the provider
    connect(add(Words::tr("Replace"), QStringLiteral("replace")), &QToolButton::clicked, this,
            [this, required] { Q_EMIT connectRequested(required); });
  }
  connect(add(Words::tr("Disconnect"), QStringLiteral("disconnect")), &QToolButton::clicked, this,
          [this, name = peer.required] { actions_.disconnectInterface(name); });
}

void Inspector::showSelected() {
  refresh();
  showTabOfSelected();
}

/// Shows the tab that contains the selected object: "interfaces" for a command, "values" for a
/// number. Does nothing if the present tab contains the object, too: "events" also contains events,
/// and both "interfaces" and "values" contain columns.
void Inspector::showTabOfSelected() {
  if (pages_->currentIndex() != kComponentPage) return;
  const auto path = ParsePath(selection_.current().toStdString());
  if (!path.ok() || path->interface.empty()) return;
  const auto* component = store_.catalogue().FindComponent(path->process, path->component);
  if (component == nullptr) return;
  const bool is_table = FindNamed(component->tables, path->interface) != nullptr;
  const auto* provided = store_.catalogue().FindProvided(path->interface_name());
  const bool is_event = provided != nullptr && FindNamed(provided->events, path->member) != nullptr;
  const int tab = tabs_->current();
  if (is_table && !path->field.empty()) {
    tabs_->setCurrent(values_page_);
  } else if (is_table ? tab != values_page_ : !(is_event && tab == events_page_)) {
    tabs_->setCurrent(interfaces_page_);
  }
  const int row = interfaces_.rowOf(selection_.current());
  if (row >= 0) interface_list_->setCurrentIndex(interfaces_.index(row));
}

void Inspector::refresh() {
  const auto path = ParsePath(selection_.current().toStdString());
  if (!path.ok())
    return showNothing(
        Words::tr("Select a component in the catalogue or in the "
                  "graph to see what it offers and needs."));
  const ProcessEntry* process = store_.catalogue().FindProcess(path->process);
  if (process == nullptr) {
    return showNothing(selection_.current() + Words::tr(" is not available."));
  }
  if (path->component.empty()) return showProcess(*process);
  const auto component = process->components.find(path->component);
  if (component == process->components.end()) {
    return showNothing(selection_.current() + Words::tr(" is not available."));
  }
  showComponent(*process, component->second);
}

void Inspector::showNothing(const QString& text) {
  name_->setText(Words::tr("Inspector"));
  state_->setVisible(false);
  process_->clear();
  nothing_->setText(text);
  pages_->setCurrentIndex(kNothingPage);
  figures_.show({});
  health_.show({}, {});
  events_->show({});
  shown_component_.clear();
  watchValues();
}

void Inspector::showProcessFacts() {
  const ProcessEntry* entry =
      store_.catalogue().FindProcess(selection_.current().section('/', 0, 0).toStdString());
  if (entry == nullptr) return;
  const ProcessDescription& process = entry->process;
  QString since = WordOf(process.state) + Words::tr(" since");
  since[0] = since[0].toUpper();
  QList<Property> facts{{Words::tr("Host"), ToQString(process.host)},
                        {Words::tr("Process id"), QString::number(process.pid)},
                        {Words::tr("Address"), ToQString(process.address)},
                        {Words::tr("Components"), QString::number(entry->components.size())},
                        {since, ClockText(process.since).section('.', 0, 0)}};
  facts += health_.processFacts();
  for (const auto& plugin : process.plugins) facts += PluginFacts(process, plugin.name);
  if (!process.reason.empty()) {
    facts.append({Words::tr("Reason"), ToQString(process.reason), {}, Property::Kind::kSentence});
  }
  process_facts_->show(facts);
}

void Inspector::showProcess(const ProcessEntry& entry) {
  const ProcessDescription& process = entry.process;
  name_->setText(ToQString(process.name));
  state_->setVisible(true);
  state_->show(MarkOf(process.state), WordOf(process.state));
  process_->clear();
  health_.show(process.name, {});
  events_->show({});
  showProcessFacts();
  forget_->setVisible(IsGone(process.state));
  pages_->setCurrentIndex(kProcessPage);
  figures_.show({});
  shown_component_.clear();
  watchValues();
}

void Inspector::showComponent(const ProcessEntry& entry, const ComponentDescription& component) {
  const bool gone = IsGone(entry.process.state);
  const QString path = ToQString(entry.process.name + '/' + component.name);
  name_->setText(ToQString(component.name));
  state_->setVisible(true);
  const auto waits = WaitsOf(entry, component);
  if (gone) {
    state_->show(StateMark::kLost);
  } else {
    state_->show(MarkOf(component.state, waits), WordOf(component.state, waits));
  }
  process_->setText(ToQString(entry.process.name));
  wanted_period_ = component.period;
  shown_component_ = path;
  lifecycle_->show(store_.catalogue(), entry.process.name, component.name);
  interfaces_.show(store_.catalogue(), entry.process.name, component.name);
  values_->showComponent(path, component, StaleReasonOf(entry.process.state, component.state));
  configuration_.show(component);
  events_->show(path);
  const bool runs = component.state == ComponentState::kActive && !gone;
  figures_.show(HasCycle(component) && runs ? path : QString());
  health_.show(entry.process.name, component.name);
  pages_->setCurrentIndex(kComponentPage);
  showCall(entry, component);
  showFigures();
  watchValues();
}

void Inspector::showCall(const ProcessEntry& entry, const ComponentDescription& component) {
  const auto path = ParsePath(selection_.current().toStdString());
  const auto provided = std::find_if(component.provided.begin(), component.provided.end(),
                                     [&](const auto& one) { return one.name == path->interface; });
  if (provided == component.provided.end()) return call_->showNothing();
  const auto command = std::find_if(provided->commands.begin(), provided->commands.end(),
                                    [&](const auto& one) { return one.name == path->member; });
  if (command == provided->commands.end()) return call_->showNothing();
  call_->showCommand(selection_.current(), *command, MatchingReads(*provided, *command));
  call_->setCareful(NeedsCare(*command, component.state));
  call_->setUnavailable(IsGone(entry.process.state)
                            ? ToQString(entry.process.name) + Words::tr(" does not answer")
                            : QString());
}

bool Inspector::focusCall() {
  if (pages_->currentIndex() != kComponentPage || call_->isHidden()) return false;
  tabs_->setCurrent(interfaces_page_);
  call_->focusFirst();
  return true;
}

void Inspector::showFigures() {
  if (shown_component_.isEmpty()) return;
  const auto path = ParsePath(shown_component_.toStdString());
  const auto* component = store_.catalogue().FindComponent(path->process, path->component);
  if (component == nullptr) return;
  const ProcessEntry& entry = *store_.catalogue().FindProcess(path->process);
  QList<Property> facts{{Words::tr("Class"), ToQString(component->class_name)}};
  if (const auto waits = WaitsOf(entry, *component); !waits.empty()) {
    facts.append({Words::tr("Waits for"), ReasonsText(waits), {}, Property::Kind::kSentence});
  }
  facts += PluginFacts(entry.process, component->library);
  if (!component->fault.empty()) {
    facts.append({Words::tr("Fault"), ToQString(component->fault), {}, Property::Kind::kSentence});
  }
  if (wanted_period_ > 0) facts += TimingFacts(wanted_period_, figures_);
  if (const auto process = health_.processFacts(); !process.isEmpty()) {
    facts.append({Words::tr("Process"), process[0].value + QStringLiteral(" · ") + process[1].value,
                  process[0].name + ' ' + process[0].value + '\n' + process[1].name + ' ' +
                      process[1].value + '\n' + process[2].name + ' ' + process[2].value});
  }
  component_facts_->show(facts);
  thread_facts_->show(ThreadFacts(*component, figures_));
}

void Inspector::showHealth() {
  interfaces_.showHealth(health_.interfaces());
  if (pages_->currentIndex() == kProcessPage) showProcessFacts();
}

void Inspector::watchValues() {
  const bool wanted = pages_->currentIndex() == kComponentPage && tabs_->current() == values_page_;
  values_->setWanted(wanted);
}

void Inspector::setOutdated(bool outdated) { state_->setStale(outdated); }

}  // namespace tendon::gui
