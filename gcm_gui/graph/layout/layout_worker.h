#pragma once

#include <gcm_gui/files/background.h>
#include <gcm_gui/graph/layout/graph_layout.h>
#include <gcm_gui/session/courier.h>

#include <QObject>
#include <QPointF>
#include <QString>
#include <map>
#include <memory>
#include <optional>

namespace tendon::gui {

/// Lets a GraphLayout find places in a thread of its own. GUI thread.
class LayoutWorker : public QObject {
  Q_OBJECT

 public:
  using Places = std::map<QString, QPointF>;

  explicit LayoutWorker(QObject* parent = nullptr);
  LayoutWorker(const LayoutWorker&) = delete;
  LayoutWorker& operator=(const LayoutWorker&) = delete;
  ~LayoutWorker() override;

  /// Finds places for all of it; `places` are those the user has chosen. arranged() tells when.
  /// Of what comes while the thread works the newest alone is done.
  void arrange(const GraphPicture& picture, const Places& places);
  /// The same where only `places` differ from the last time, which takes no time.
  void move(const GraphPicture& picture, const Places& places);

  /// Of what was arranged last. What has come since has no place.
  [[nodiscard]] const Arrangement& arrangement() const { return arrangement_; }
  /// What was asked for last is yet to come.
  [[nodiscard]] bool isAtWork() const { return is_at_work_; }

 Q_SIGNALS:
  /// `moved`: something stands elsewhere than before.
  void arranged(bool moved);

 private:
  struct Order {
    GraphPicture picture;
    Places places;
  };

  void doNow(const GraphPicture& picture, const Places& places);
  void doInThread(Order order);
  void finish(bool moved, const Arrangement& arrangement);

  std::shared_ptr<GraphLayout> layout_;  // of the thread while it is at work
  std::shared_ptr<Courier> courier_;
  Arrangement arrangement_;
  bool is_at_work_ = false;
  std::optional<Order> next_;
  Background thread_{QT_TRANSLATE_NOOP("Words", "the layout of the graph")};
};

}  // namespace tendon::gui
