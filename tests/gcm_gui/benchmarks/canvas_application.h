#pragma once

#include <QApplication>
#include <memory>

namespace tendon::benchmark {

/// The QApplication that windows need, without a screen; the first object sets it up. Main thread
/// only.
class CanvasApplication {
 public:
  CanvasApplication();

 private:
  std::shared_ptr<QApplication> application_;
};

}  // namespace tendon::benchmark
