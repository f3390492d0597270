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

/// The commands of the graph besides connecting: its map, a search, the positions of components,
/// and pictures. They are in the menu "Graph", on keys, in the palette, and in the graph's own
/// menu.
class GraphCommands : public QObject {
  Q_OBJECT

 public:
  GraphCommands(const WindowParts& parts, GraphView& graph, QWidget& window);

  void addCommands(Commands& commands);
  /// Keeps the user's positions for the next run and saves them with the system file; opening a
  /// system file applies its positions.
  void keepPlaces(const WindowParts& parts, SystemDocument& document);
  /// The menu for a component under the mouse, which is also selected.
  void setComponentMenu(QMenu& menu, Selection& selection);
  /// Undoes the last move of a component; false if there is none or the user has acted since then.
  bool undoMove();
  [[nodiscard]] GraphMap& map() const { return *map_; }
  [[nodiscard]] GraphSearch& search() const { return *search_; }

 Q_SIGNALS:
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  void undoPositions();
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
