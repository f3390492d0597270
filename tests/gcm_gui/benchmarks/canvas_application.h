#pragma once

#include <QApplication>
#include <memory>

namespace tendon::benchmark {

/// The QApplication that windows need, without a screen. The first CanvasApplication creates it.
/// Main thread only.
class CanvasApplication {
 public:
  CanvasApplication();

 private:
  std::shared_ptr<QApplication> application_;
};

}  // namespace tendon::benchmark
