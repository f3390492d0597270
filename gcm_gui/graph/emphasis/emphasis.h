#pragma once

#include <QObject>
#include <QString>
#include <QVariantAnimation>
#include <set>

namespace tendon::gui {

class GraphScene;
class VeilItem;

/// Lets a part of the graph stand out: all else is dimmed by one veil over it, which comes and goes
/// gently in a graph of usual size. GUI thread; each change costs a look at all items.
class Emphasis : public QObject {
  Q_OBJECT

 public:
  struct Names {
    std::set<QString> components;  ///< by path
    std::set<QString> edges;       ///< by path of the required interface

    [[nodiscard]] bool empty() const { return components.empty() && edges.empty(); }
    bool operator==(const Names&) const = default;
  };

  /// The scene owns it.
  explicit Emphasis(GraphScene& scene);

  /// What the pointer is on; before what is found.
  void setPointed(Names names);
  /// What is looked for.
  void setFound(Names names);

  /// Without the veil for a moment, for who draws the graph elsewhere.
  void lift(bool lifted);

  /// What stands out, or is to as soon as the veil is there; nothing where all is as usual.
  [[nodiscard]] const Names& names() const { return pointed_.empty() ? found_ : pointed_; }
  /// How much all else is dimmed, from 0 to 1.
  [[nodiscard]] double veil() const;

 private:
  void refresh();
  void raise();

  GraphScene& scene_;
  VeilItem* veil_;
  QVariantAnimation fade_;
  Names pointed_;
  Names found_;
  Names raised_;  // the last ones, until the veil is gone
};

}  // namespace tendon::gui
