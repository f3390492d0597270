#pragma once

#include <gcm_gui/files/file_writer.h>

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

namespace tendon::gui {

/// Runs tasks one after another in its own thread. If a task throws, the ExceptionGuard reports it.
/// A task may run longer than this object exists. Therefore a task must not use the object that
/// requested it.
///
/// The destructor waits for the tasks, so it fits work that must be completed, in an object that is
/// destroyed when the program ends. An object that may be destroyed while a window is open calls
/// handOver() first, so that no handler waits.
///
/// Thread safety: GUI thread only.
class Background {
 public:
  using Task = std::function<void()>;

  /// When the program ends, it waits at most this long for all tasks that were handed over.
  static constexpr std::chrono::seconds kTimeoutAtEnd{2};

  /// `what` names the work, such as QT_TRANSLATE_NOOP("Words", "a system file"). This name is used
  /// on stderr and by the ExceptionGuard. `timeout` is the maximum time that the destructor waits.
  explicit Background(const char* what, std::chrono::milliseconds timeout = FileWriter::kTimeout);
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  /// Waits for all tasks, at most for `timeout`. Then reports unfinished tasks on stderr. Does not
  /// wait after handOver().
  ~Background();

  void start(Task task);
  /// Drops the tasks that have not begun.
  void dropWaiting();
  /// Lets the thread finish its tasks on its own, and does not wait for it. The thread releases
  /// `belongings` after the last task. start() must not be called any more.
  void handOver(std::shared_ptr<const void> belongings = nullptr);

 private:
  struct Queue;
  class DetachedThreads;

  static void work(const std::shared_ptr<Queue>& queue);
  /// Waits until `begin` + `timeout` for the thread of a closed queue. Then reports it on stderr.
  static void finish(Queue& queue, std::thread thread, std::chrono::steady_clock::time_point begin,
                     std::chrono::milliseconds timeout);

  const std::chrono::milliseconds timeout_;
  std::shared_ptr<Queue> queue_;
  std::thread thread_;
};

}  // namespace tendon::gui
