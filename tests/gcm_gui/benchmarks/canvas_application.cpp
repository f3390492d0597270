#include <gcm_gui/benchmarks/canvas_application.h>
#include <gcm_gui/theme/theme.h>

namespace tendon::benchmark {
namespace {

std::shared_ptr<QApplication> Started() {
  static int count = 1;
  static char name[] = "report";
  static char* arguments[] = {name, nullptr};
  static std::weak_ptr<QApplication> running;
  if (auto there = running.lock()) return there;
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  qunsetenv("DBUS_SESSION_BUS_ADDRESS");  // the results must not depend on the look of the desktop
  auto started = std::make_shared<QApplication>(count, arguments);
  gui::Theme::instance().choose(gui::Theme::Choice::kDark);
  running = started;
  return started;
}

}  // namespace

CanvasApplication::CanvasApplication() : application_(Started()) {}

}  // namespace tendon::benchmark
