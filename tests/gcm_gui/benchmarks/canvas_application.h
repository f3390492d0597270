#pragma once

#include <QApplication>
#include <memory>

namespace tendon::benchmark {

/// What windows need before they can be drawn, without a screen; the first one made sets it up. The
/// main thread's.
class CanvasApplication {
 public:
  CanvasApplication();

 private:
  std::shared_ptr<QApplication> application_;
};

}  // namespace tendon::benchmark
