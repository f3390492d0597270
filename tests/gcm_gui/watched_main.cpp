#include <gcm_gui/window/watched_application.h>

#include "support/run_tests.h"

/// The main function for tests that measure the handlers of the window.
int main(int argc, char** argv) {
  return tendon::gui::RunTests<tendon::gui::WatchedApplication>(argc, argv);
}
