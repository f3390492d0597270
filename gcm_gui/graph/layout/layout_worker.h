#pragma once

#include <gcm_gui/files/background.h>
#include <gcm_gui/files/gui_poster.h>
#include <gcm_gui/graph/layout/graph_layout.h>

#include <QObject>
#include <QPointF>
#include <QString>
#include <map>
#include <memory>
#include <optional>

namespace tendon::gui {

/// Runs a GraphLayout in a thread of its own. GUI thread.
class LayoutWorker : public QObject {
  Q_OBJECT

 public:
  using Places = std::map<QString, QPointF>;

  explicit LayoutWorker(QObject* parent = nullptr);
  LayoutWorker(const LayoutWorker&) = delete;
  LayoutWorker& operator=(const LayoutWorker&) = delete;
  ~LayoutWorker() override;

  /// Arranges the whole picture; `places` are those chosen by the user. arranged() follows. Of the
  /// requests that arrive while the thread works, only the newest is executed.
  void arrange(const GraphPicture& picture, const Places& places);
  /// The same, faster, if only `places` have changed since the last call.
  void move(const GraphPicture& picture, const Places& places);

  /// The latest result; items that were added later are not in it.
  [[nodiscard]] const Arrangement& arrangement() const { return arrangement_; }
  /// True while the last request is not finished.
  [[nodiscard]] bool isAtWork() const { return is_at_work_; }

 Q_SIGNALS:
  /// `moved` is true if any position has changed.
  void arranged(bool moved);

 private:
  struct Order {
    GraphPicture picture;
    Places places;
  };

  void doNow(const GraphPicture& picture, const Places& places);
  void doInThread(Order order);
  void finish(bool moved, const Arrangement& arrangement);

  std::shared_ptr<GraphLayout> layout_;  // used by the thread while it works
  std::shared_ptr<GuiPoster> poster_;
  Arrangement arrangement_;
  bool is_at_work_ = false;
  std::optional<Order> next_;
  Background thread_{QT_TRANSLATE_NOOP("Words", "the layout of the graph")};
};

}  // namespace tendon::gui
