#include <gcm_gui/commands/graph_commands.h>

#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/commands/commands.h>
#include <gcm_gui/graph/graph_export.h>
#include <gcm_gui/graph/graph_map.h>
#include <gcm_gui/graph/graph_search.h>
#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/graph/layout/node_positions.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/selection.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/system/system_document.h>
#include <tendon/gcm/system_file.h>

#include <QAction>
#include <QMenu>
#include <map>
#include <string>

namespace tendon::gui {
namespace {

// The following functions convert between positions in the graph and positions in a system file.

std::map<std::string, SystemFile::Position> SavedPositions(const NodePositions& places) {
  std::map<std::string, SystemFile::Position> layout;
  for (const auto& [path, place] : places.all()) {
    layout.emplace(path.toStdString(), SystemFile::Position{place.x(), place.y()});
  }
  return layout;
}

NodePositions::Map PlacesOf(const SystemFile& file) {
  NodePositions::Map places;
  for (const auto& [path, position] : file.layout) {
    const QPointF place(position.x, position.y);
    if (IsPlausiblePosition(place)) places.emplace(ToQString(path), place);
  }
  return places;
}

}  // namespace

GraphCommands::GraphCommands(const WindowParts& parts, GraphView& graph, QWidget& window)
    : QObject(&window),
      graph_(graph),
      map_(new GraphMap(graph)),
      search_(new GraphSearch(graph)),
      export_(new GraphExport(parts.store, graph.graph(), window)) {
  connect(search_, &GraphSearch::chosen, &graph, &GraphView::goTo);
  connect(export_, &GraphExport::notice, this, &GraphCommands::notice);
  graph.setContextMenuPolicy(Qt::CustomContextMenu);
  connect(&graph, &QWidget::customContextMenuRequested, this, &GraphCommands::openMenu);
}

void GraphCommands::keepPlaces(const WindowParts& parts, SystemDocument& document) {
  NodePositions& places = graph_.graph().nodePositions();
  if (!parts.kept.isEmpty()) places.keepIn(parts.kept + QStringLiteral("/graph.json"));
  document.setLayout(SavedPositions(places));
  connect(&places, &NodePositions::notice, this, &GraphCommands::notice);
  connect(&places, &NodePositions::changed, &document,
          [&places, &document] { document.setLayout(SavedPositions(places)); });
  connect(&document, &SystemDocument::opened, &places,
          [&places, &document] { places.move(PlacesOf(document.file())); });
  connect(&parts.activity, &ActivityModel::finished, &places,
          Guarded(&places, &NodePositions::onOtherAction));
}

void GraphCommands::addCommands(Commands& commands) {
  const auto add = [&](const QString& text, const QKeySequence& key, auto what) -> QAction& {
    return commands.add(Commands::Menu::kGraph, text, key, what);
  };
  menu_ = &commands.menu(Commands::Menu::kGraph);
  add(Words::tr("&Find in the graph…"), Qt::Key_Slash, [this] { search_->open(); });
  add(Words::tr("Show &all of the graph"), {}, [this] { graph_.fit(); });
  QAction& map = add(Words::tr("&Map of the graph"), Qt::Key_M,
                     [this] { map_->setWanted(!map_->isWanted()); });
  map.setCheckable(true);
  map.setChecked(map_->isWanted());
  menu_->addSeparator();
  add(Words::tr("&Undo the last move"), {}, [this] {
    graph_.graph().nodePositions().canUndo() ? undoPositions()
                                             : Q_EMIT notice(Words::tr("Nothing has been moved"));
  });
  add(Words::tr("&Reset the layout of the graph"), {}, [this] {
    graph_.graph().nodePositions().reset();
    graph_.fit();
    Q_EMIT notice(Words::tr("All nodes are back at their automatic positions · Ctrl+Z undoes"));
  });
  menu_->addSeparator();
  add(Words::tr("Save a &picture of the graph…"), {}, [this] { export_->ask(); });
  add(Words::tr("&Copy the picture of the graph"), {}, [this] { export_->copy(); });
}

bool GraphCommands::undoMove() {
  const bool is_newest = graph_.graph().nodePositions().isNewest();
  if (is_newest) undoPositions();
  return is_newest;
}

void GraphCommands::undoPositions() {
  graph_.graph().nodePositions().undo();
  Q_EMIT notice(Words::tr("Moved back"));
}

void GraphCommands::setComponentMenu(QMenu& menu, Selection& selection) {
  component_menu_ = &menu;
  selection_ = &selection;
}

void GraphCommands::openMenu(const QPoint& position) {
  const QString path = graph_.pathAt(position);
  if (component_menu_ != nullptr && !path.isEmpty()) {
    if (!selection_->contains(path)) selection_->select(path);
    return component_menu_->popup(graph_.mapToGlobal(position));
  }
  if (menu_ != nullptr) menu_->popup(graph_.mapToGlobal(position));
}

}  // namespace tendon::gui
