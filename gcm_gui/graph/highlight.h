#pragma once

#include <QObject>
#include <QString>
#include <QVariantAnimation>
#include <set>

namespace tendon::gui {

class GraphScene;
class DimmingItem;

/// Highlights a part of the graph by dimming all the rest, with a fade in and out if the graph is
/// of moderate size. GUI thread; each change visits all items.
class Highlight : public QObject {
  Q_OBJECT

 public:
  struct Names {
    std::set<QString> components;  ///< by path
    std::set<QString> edges;       ///< by path of the required interface

    [[nodiscard]] bool empty() const { return components.empty() && edges.empty(); }
    bool operator==(const Names&) const = default;
  };

  /// The scene owns it.
  explicit Highlight(GraphScene& scene);

  /// The part under the pointer; takes precedence over the found part.
  void setPointed(Names names);
  /// The part that a search has found.
  void setFound(Names names);

  /// Removes the dimming temporarily, for code that draws the graph elsewhere.
  void lift(bool lifted);

  /// The highlighted part, also while the rest fades; empty if nothing is highlighted.
  [[nodiscard]] const Names& names() const { return pointed_.empty() ? found_ : pointed_; }
  /// How much the rest is dimmed, from 0 to 1.
  [[nodiscard]] double dimming() const;

 private:
  void refresh();
  void raise();

  GraphScene& scene_;
  DimmingItem* dimming_item_;
  QVariantAnimation fade_;
  Names pointed_;
  Names found_;
  Names raised_;  // the last part, kept until the fade has ended
};

}  // namespace tendon::gui
