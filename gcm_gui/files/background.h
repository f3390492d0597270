#pragma once

#include <gcm_gui/files/file_writer.h>

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

namespace tendon::gui {

/// Runs tasks one after another in its own thread; the ExceptionGuard reports a task that throws. A
/// task must not use its requester: the destructor abandons a task that takes too long, which then
/// continues.
class Background {
 public:
  using Task = std::function<void()>;

  /// `what` names the work for stderr and the ExceptionGuard: QT_TRANSLATE_NOOP("Words", "a system
  /// file"). `patience` is how long the destructor waits.
  explicit Background(const char* what, std::chrono::milliseconds patience = FileWriter::kPatience);
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  /// Waits for all tasks at most `patience`; then reports unfinished tasks on stderr.
  ~Background();

  void start(Task task);

 private:
  struct Queue;

  static void work(const char* what, const std::shared_ptr<Queue>& queue);

  const char* what_;
  const std::chrono::milliseconds patience_;
  std::shared_ptr<Queue> queue_;
  std::thread thread_;
};

}  // namespace tendon::gui
