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

/// Runs a GraphLayout in a separate thread. The functions are for the GUI thread.
class LayoutWorker : public QObject {
  Q_OBJECT

 public:
  using Places = std::map<QString, QPointF>;

  explicit LayoutWorker(QObject* parent = nullptr);
  LayoutWorker(const LayoutWorker&) = delete;
  LayoutWorker& operator=(const LayoutWorker&) = delete;
  ~LayoutWorker() override;

  /// Arranges the whole picture; arranged() is emitted afterwards. `places` are the positions
  /// chosen by the user. While the thread is busy, only the newest of the arriving requests is
  /// kept.
  void arrange(const GraphPicture& picture, const Places& places);
  /// Does the same as arrange(), but faster. Use it only if nothing but `places` has changed since
  /// the last call.
  void move(const GraphPicture& picture, const Places& places);

  /// The latest result. It does not contain items that were added later.
  [[nodiscard]] const Arrangement& arrangement() const { return arrangement_; }
  /// True until the last request is finished.
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

  std::shared_ptr<GraphLayout> layout_;  // used by the thread while it is busy
  std::shared_ptr<GuiPoster> poster_;
  Arrangement arrangement_;
  bool is_at_work_ = false;
  std::optional<Order> next_;
  Background thread_{QT_TRANSLATE_NOOP("Words", "the layout of the graph")};
};

}  // namespace tendon::gui
