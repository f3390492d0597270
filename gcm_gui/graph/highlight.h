#pragma once

#include <QObject>
#include <QString>
#include <QVariantAnimation>
#include <set>

namespace tendon::gui {

class GraphScene;
class DimmingItem;

/// Highlights a part of the graph by dimming all other items. The dimming fades in and out unless
/// the graph is large. GUI thread; each change visits all items.
class Highlight : public QObject {
  Q_OBJECT

 public:
  struct Names {
    std::set<QString> components;  ///< by path
    std::set<QString> edges;       ///< by path of the required interface

    [[nodiscard]] bool empty() const { return components.empty() && edges.empty(); }
    bool operator==(const Names&) const = default;
  };

  /// The scene owns this object.
  explicit Highlight(GraphScene& scene);

  /// Sets the part under the pointer. It takes precedence over the part set by setFound().
  void setPointed(Names names);
  /// Sets the part that was found by a search.
  void setFound(Names names);

  /// Removes the dimming while `lifted` is true; used by code that draws the graph elsewhere.
  void lift(bool lifted);

  /// The highlighted part, also during the fade; empty if nothing is highlighted.
  [[nodiscard]] const Names& names() const { return pointed_.empty() ? found_ : pointed_; }
  /// The present strength of the dimming, from 0 to 1.
  [[nodiscard]] double dimming() const;

 private:
  void refresh();
  void raise();

  GraphScene& scene_;
  DimmingItem* dimming_item_;
  QVariantAnimation fade_;
  Names pointed_;
  Names found_;
  Names raised_;  // the part that was highlighted last; kept until the fade has ended
};

}  // namespace tendon::gui
