#pragma once

#include <gcm_gui/window/window_parts.h>

#include <QObject>
#include <QPoint>
#include <QString>

class QMenu;

namespace tendon::gui {

class Commands;
class GraphExport;
class GraphMap;
class GraphSearch;
class GraphView;
class Selection;
class SystemDocument;

/// What can be done with the graph besides connecting: its map, a search, where components stand,
/// and pictures of it. In the menu "Graph", on keys, in the palette, and in the menu of the graph
/// itself.
class GraphCommands : public QObject {
  Q_OBJECT

 public:
  GraphCommands(const WindowParts& parts, GraphView& graph, QWidget& window);

  void addCommands(Commands& commands);
  /// Where components were put is kept for the next time, and saved with the system file; one that
  /// is opened puts them where it says.
  void keepPlaces(const WindowParts& parts, SystemDocument& document);
  /// Where the mouse is on a component it is selected, and has this menu.
  void setComponentMenu(QMenu& menu, Selection& selection);
  /// Takes back the last move of a component, if nothing else was done since; false otherwise.
  bool undoMove();
  [[nodiscard]] GraphMap& map() const { return *map_; }
  [[nodiscard]] GraphSearch& search() const { return *search_; }

 Q_SIGNALS:
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  void takeBack();
  void openMenu(const QPoint& position);

  GraphView& graph_;
  GraphMap* map_;
  GraphSearch* search_;
  GraphExport* export_;
  QMenu* menu_ = nullptr;
  QMenu* component_menu_ = nullptr;
  Selection* selection_ = nullptr;
};

}  // namespace tendon::gui
