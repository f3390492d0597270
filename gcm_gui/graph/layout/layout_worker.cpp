#include <gcm_gui/graph/layout/layout_worker.h>

#include <gcm_gui/guard/exception_guard.h>

#include <utility>

namespace tendon::gui {

LayoutWorker::LayoutWorker(QObject* parent)
    : QObject(parent),
      layout_(std::make_shared<GraphLayout>()),
      poster_(std::make_shared<GuiPoster>(this)) {}

LayoutWorker::~LayoutWorker() { poster_->detach(); }

void LayoutWorker::arrange(const GraphPicture& picture, const Places& places) {
  if (is_at_work_) {
    next_ = Order{picture, places};
  } else {
    doInThread({picture, places});
  }
}

void LayoutWorker::move(const GraphPicture& picture, const Places& places) {
  if (is_at_work_) {
    next_ = Order{picture, places};
  } else {
    doNow(picture, places);
  }
}

void LayoutWorker::doNow(const GraphPicture& picture, const Places& places) {
  layout_->setPlaces(places);
  const bool moved = layout_->update(picture);
  if (moved) arrangement_ = layout_->arrangement();
  Q_EMIT arranged(moved);
}

void LayoutWorker::doInThread(Order order) {
  is_at_work_ = true;
  thread_.start([this, layout = layout_, poster = poster_, order = std::move(order)] {
    bool moved = false;
    ExceptionGuard::run(QT_TRANSLATE_NOOP("Words", "the layout of the graph"), [&] {
      layout->setPlaces(order.places);
      moved = layout->update(order.picture);
    });
    poster->post(
        [this, moved, arrangement = layout->arrangement()] { finish(moved, arrangement); });
  });
}

void LayoutWorker::finish(bool moved, const Arrangement& arrangement) {
  is_at_work_ = false;
  arrangement_ = arrangement;
  Q_EMIT arranged(moved);
  if (const auto next = std::exchange(next_, std::nullopt)) arrange(next->picture, next->places);
}

}  // namespace tendon::gui
