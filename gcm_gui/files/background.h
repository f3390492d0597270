#pragma once

#include <gcm_gui/files/file_writer.h>

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

namespace tendon::gui {

/// Runs tasks one after another in its own thread. If a task throws, the ExceptionGuard reports it.
/// The destructor waits at most `patience` for the running task; the task then continues to run.
/// Therefore a task must not use the object that requested it.
class Background {
 public:
  using Task = std::function<void()>;

  /// `what` names the work, such as QT_TRANSLATE_NOOP("Words", "a system file"). This name is used
  /// on stderr and by the ExceptionGuard. `patience` is the maximum time that the destructor waits.
  explicit Background(const char* what, std::chrono::milliseconds patience = FileWriter::kPatience);
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  /// Waits for all tasks, at most for `patience`. Then reports unfinished tasks on stderr.
  ~Background();

  void start(Task task);
  /// Drops the tasks that have not begun.
  void dropWaiting();

 private:
  struct Queue;

  static void work(const char* what, const std::shared_ptr<Queue>& queue);

  const char* what_;
  const std::chrono::milliseconds patience_;
  std::shared_ptr<Queue> queue_;
  std::thread thread_;
};

}  // namespace tendon::gui
