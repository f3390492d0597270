#include <gcm_gui/window/watched_application.h>

#include "support/run_tests.h"

/// For tests that ask how long the handlers of the window took.
int main(int argc, char** argv) {
  return tendon::gui::RunTests<tendon::gui::WatchedApplication>(argc, argv);
}
