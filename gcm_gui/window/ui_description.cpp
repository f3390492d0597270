#include <gcm_gui/window/ui_description.h>

#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/connect/candidate_list.h>
#include <gcm_gui/connect/candidate_panel.h>
#include <gcm_gui/files/file_writer.h>
#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/graph/items/port_item.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/recording/window_recording.h>
#include <gcm_gui/replay/replay_session.h>
#include <gcm_gui/replay/replay_strip.h>
#include <gcm_gui/replay/replay_stripe.h>
#include <gcm_gui/replay/window_replay.h>
#include <gcm_gui/session/link_state.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gcm_gui/window/main_window.h>
#include <gcm_gui/window/top_bar.h>
#include <gcm_gui/window/watched_application.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QTabBar>
#include <chrono>

namespace tendon::gui {
namespace {

constexpr std::chrono::milliseconds kPeriod{200};

QJsonArray Rectangle(const QRect& rect) {
  return {rect.x(), rect.y(), rect.width(), rect.height()};
}

QJsonArray OnScreen(const QWidget& widget, const QRect& rect) {
  return Rectangle({widget.mapToGlobal(rect.topLeft()), rect.size()});
}

QString Word(PortItem::Role role) {
  switch (role) {
    case PortItem::Role::kPlain:
      return QStringLiteral("plain");
    case PortItem::Role::kChosen:
      return QStringLiteral("chosen");
    case PortItem::Role::kCandidate:
      return QStringLiteral("candidate");
    case PortItem::Role::kUnfit:
      break;
  }
  return QStringLiteral("unfit");
}

QJsonObject Processes(const Catalogue& catalogue) {
  QJsonObject processes;
  for (const auto& [name, entry] : catalogue.processes()) {
    QJsonObject components;
    for (const auto& [component_name, component] : entry.components) {
      components[ToQString(component_name)] = ToQString(ToString(component.state));
    }
    processes[ToQString(name)] = QJsonObject{{"state", ToQString(ToString(entry.process.state))},
                                             {"components", components}};
  }
  return processes;
}

QJsonObject Connections(const Catalogue& catalogue) {
  QJsonObject connections;
  for (const auto& connection : catalogue.connections()) {
    connections[ToQString(ToString(connection.required))] =
        QJsonObject{{"provided", ToQString(ToString(connection.provided))},
                    {"state", ToQString(ToString(connection.state))},
                    {"reason", ToQString(connection.reason)}};
  }
  return connections;
}

// JSON in Qt has only signed 64-bit integers, so larger unsigned numbers become texts.
QJsonValue Exactly(const ExactNumber& number) {
  const auto integer = static_cast<std::int64_t>(number.word());
  if (!number.isInteger()) return number.nearest();
  if (number.kind() == ExactNumber::Kind::kUnsigned && integer < 0) return number.text();
  return qint64{integer};
}

QJsonObject Curves(const PlotPanel& plots) {
  QJsonObject curves;
  for (int plot = 0; plot < plots.plotCount(); ++plot) {
    for (const auto& curve : plots.plot(plot).curves().curves()) {
      const SampleRing& samples = curve->samples();
      QJsonObject figures{{"rows", static_cast<double>(samples.endIndex())},
                          {"lost", static_cast<double>(samples.lost())},
                          {"repeated", static_cast<double>(samples.repeated())},
                          {"rate", curve->rate()},
                          {"stale", curve->isStale()}};
      if (const auto number = curve->latestNumber()) figures["value"] = Exactly(*number);
      if (!samples.empty()) {
        figures["tick"] = static_cast<double>(samples.tick(samples.endIndex() - 1));
      }
      curves[curve->path()] = figures;
    }
  }
  return curves;
}

QJsonObject LastAction(const ActivityModel& activity) {
  if (activity.rowCount() == 0) return {};
  const Action& action = activity.action(0);
  const QModelIndex row = activity.index(0, 0);
  return {{"text", row.data(Qt::AccessibleTextRole).toString()},
          {"running", action.outcome == Action::Outcome::kRunning},
          {"refused", action.outcome == Action::Outcome::kRefused},
          {"seconds", action.seconds}};
}

QJsonObject Recording(const RecordingController& recording) {
  const auto& status = recording.progress().status;
  return {{"running", recording.state() == RecordingController::State::kRecording},
          {"file", recording.file()},
          {"rows", static_cast<double>(status.counts.rows)},
          {"lost", static_cast<double>(status.losses.all())}};
}

/// The shown recording. Times are in s since its start.
QJsonObject Replaying(const WindowReplay& replay) {
  const ReplaySession& session = replay.session();
  const auto seconds = [&](std::int64_t time) {
    return static_cast<double>(time - session.facts().first) / 1e9;
  };
  return {{"file", session.file()},
          {"open", session.state() == ReplaySession::State::kOpen},
          {"stripe", replay.strip().stripe().text()},
          {"playing", session.clock().isPlaying()},
          {"speed", session.clock().speed()},
          {"seconds", seconds(session.position())},
          {"length", seconds(session.facts().last)}};
}

}  // namespace

UiDescription::UiDescription(MainWindow& window, const QString& file)
    : QObject(&window), window_(window), file_(file) {
  connect(&timer_, &QTimer::timeout, this, &UiDescription::write);
  timer_.start(kPeriod);
}

QJsonObject UiDescription::widgets() const {
  QJsonObject widgets;
  for (const QWidget* widget : window_.findChildren<QWidget*>()) {
    const QString name = widget->objectName();
    const bool internal = name.isEmpty() || name.startsWith(QStringLiteral("qt_"));
    if (internal || !widget->isVisible() || widgets.contains(name)) continue;
    widgets[name] = OnScreen(*widget, widget->rect());
    const auto* tabs = qobject_cast<const QTabBar*>(widget);
    for (int tab = 0; tabs != nullptr && tab < tabs->count(); ++tab) {
      widgets[name + '/' + tabs->tabText(tab)] = OnScreen(*tabs, tabs->tabRect(tab));
    }
  }
  return widgets;
}

QJsonObject UiDescription::rows() const {
  QJsonObject rows;
  const CatalogueTree& tree = window_.catalogue().tree();
  const auto visible = tree.visibleRows();
  for (auto row = visible.begin(); row != visible.end(); ++row) {
    rows[row.key()] = OnScreen(*tree.viewport(), row.value());
  }
  return rows;
}

QJsonObject UiDescription::nodes() const {
  QJsonObject nodes;
  const GraphView& view = window_.graph();
  if (!view.isVisible()) return nodes;
  for (const auto& [path, item] : view.graph().components()) {
    const QRect rect = view.mapFromScene(item->sceneRect()).boundingRect();
    nodes[path] = OnScreen(*view.viewport(), rect);
  }
  return nodes;
}

QJsonObject UiDescription::ports() const {
  QJsonObject ports;
  const GraphView& view = window_.graph();
  if (!view.isVisible()) return ports;
  for (const PortItem* item : view.graph().ports()) {
    const QPoint centre = view.mapFromScene(item->scenePos());
    const QRect disc(centre - QPoint(5, 5), QSize(10, 10));
    ports[ToQString(ToString(item->port().name))] =
        QJsonObject{{"rect", OnScreen(*view.viewport(), disc)},
                    {"role", Word(item->role())},
                    {"number", item->number()}};
  }
  return ports;
}

QJsonObject UiDescription::candidates() const {
  QJsonObject candidates;
  const CandidateList& list = window_.candidates().list();
  for (int row = 0; list.isVisible() && row < list.model()->rowCount(); ++row) {
    const QModelIndex index = list.model()->index(row, 0);
    const QString path = index.data(kPathRole).toString();
    if (!path.isEmpty()) candidates[path] = OnScreen(*list.viewport(), list.visualRect(index));
  }
  return candidates;
}

QJsonObject UiDescription::facts() const {
  const WindowParts& parts = window_.parts();
  const Catalogue& catalogue = parts.store.catalogue();
  QJsonObject facts{{"gcm", window_.topBar().linkText()},
                    {"gcmAddress", parts.link.address()},
                    {"gcmConnected", parts.link.state() == LinkState::State::kConnected},
                    {"hosted", parts.link.isHosted()},
                    {"revision", static_cast<double>(catalogue.revision())},
                    {"items", window_.catalogueModel().itemCount()},
                    {"processes", Processes(catalogue)},
                    {"connections", Connections(catalogue)},
                    {"curves", Curves(window_.plots())},
                    {"lastAction", LastAction(parts.activity)},
                    {"recording", Recording(window_.recording().controller())},
                    {"paused", window_.plots().isPaused()},
                    {"connecting", window_.connectMode().active()},
                    {"selection", QJsonArray::fromStringList(window_.selection().paths())}};
  if (window_.replay() != nullptr) facts["replay"] = Replaying(*window_.replay());
  if (const auto* application = qobject_cast<WatchedApplication*>(qApp)) {
    using Milliseconds = std::chrono::duration<double, std::milli>;
    facts["longestHandlerMs"] = Milliseconds(application->longestHandler()).count();
    facts["longestHandler"] = application->longestName();
  }
  return facts;
}

void UiDescription::write() {
  const QJsonObject description{{"schema", 1},
                                {"window", OnScreen(window_, window_.rect())},
                                {"widgets", widgets()},
                                {"rows", rows()},
                                {"nodes", nodes()},
                                {"ports", ports()},
                                {"candidates", candidates()},
                                {"facts", facts()}};
  const QByteArray text = QJsonDocument(description).toJson();
  if (text == written_) return;
  written_ = text;
  FileWriter::instance().write(file_, text, this, [this](const QString& refusal) {
    if (!refusal.isEmpty()) written_.clear();  // so that the next update writes the file again
  });
}

}  // namespace tendon::gui
