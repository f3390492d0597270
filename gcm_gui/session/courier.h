#pragma once

#include <QMetaObject>
#include <QObject>
#include <mutex>
#include <utility>

namespace tendon::gui {

/// Carries calls from any thread to the thread of its receiver, in order. Handlers of network
/// threads share it, so that one that outlives the receiver finds nobody and does nothing.
class Courier {
 public:
  explicit Courier(QObject* receiver) : receiver_(receiver) {}
  Courier(const Courier&) = delete;
  Courier& operator=(const Courier&) = delete;

  template <typename Call>
  void post(Call&& call) {
    const std::lock_guard lock(mutex_);
    if (receiver_ != nullptr) {
      QMetaObject::invokeMethod(receiver_, std::forward<Call>(call), Qt::QueuedConnection);
    }
  }

  /// After it returns nothing more is posted. The receiver calls it before it goes.
  void detach() {
    const std::lock_guard lock(mutex_);
    receiver_ = nullptr;
  }

 private:
  std::mutex mutex_;
  QObject* receiver_;
};

}  // namespace tendon::gui
