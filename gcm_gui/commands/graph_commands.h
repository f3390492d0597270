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

/// The commands of the graph except those for connecting: the map, the search, the positions of
/// components, and the export of pictures. They are in the menu "Graph", in the palette and in the
/// context menu of the graph, and have keys.
class GraphCommands : public QObject {
  Q_OBJECT

 public:
  GraphCommands(const WindowParts& parts, GraphView& graph, QWidget& window);

  void addCommands(Commands& commands);
  /// Keeps the positions chosen by the user for the next run, and saves them with the system file.
  /// When a system file is opened, its positions are applied.
  void keepPlaces(const WindowParts& parts, SystemDocument& document);
  /// Sets the context menu of a component. Opening it selects the component under the mouse.
  void setComponentMenu(QMenu& menu, Selection& selection);
  /// Undoes the last move of a component. Returns false if there is none, or if the user has done
  /// something else since then.
  bool undoMove();
  [[nodiscard]] GraphMap& map() const { return *map_; }
  [[nodiscard]] GraphSearch& search() const { return *search_; }

 Q_SIGNALS:
  /// Emitted with one sentence for the user.
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
