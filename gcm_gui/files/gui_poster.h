#pragma once

#include <QMetaObject>
#include <QObject>
#include <mutex>
#include <utility>

namespace tendon::gui {

/// Posts calls from any thread to the thread of the receiver, in order. Handlers in network threads
/// share the poster; after detach(), their calls have no effect.
class GuiPoster {
 public:
  explicit GuiPoster(QObject* receiver) : receiver_(receiver) {}
  GuiPoster(const GuiPoster&) = delete;
  GuiPoster& operator=(const GuiPoster&) = delete;

  template <typename Call>
  void post(Call&& call) {
    const std::lock_guard lock(mutex_);
    if (receiver_ != nullptr) {
      QMetaObject::invokeMethod(receiver_, std::forward<Call>(call), Qt::QueuedConnection);
    }
  }

  /// Stops the posting: after this function has returned, nothing is posted any more. The receiver
  /// must call it before the receiver is destroyed.
  void detach() {
    const std::lock_guard lock(mutex_);
    receiver_ = nullptr;
  }

 private:
  std::mutex mutex_;
  QObject* receiver_;
};

}  // namespace tendon::gui
