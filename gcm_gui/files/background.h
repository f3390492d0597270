#pragma once

#include <gcm_gui/files/file_writer.h>

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

namespace tendon::gui {

/// Does one task after another in a thread of its own; the Fence tells of one that throws. A task
/// must need nothing of who has asked for it: one that takes too long at the end is left behind,
/// and goes on.
class Background {
 public:
  using Task = std::function<void()>;

  /// `what` is being done, for stderr and the Fence: QT_TRANSLATE_NOOP("Words", "a system file").
  /// `patience`: of the destructor.
  explicit Background(const char* what, std::chrono::milliseconds patience = FileWriter::kPatience);
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  /// Waits for all tasks as long as its patience lasts; then it says so on stderr.
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
