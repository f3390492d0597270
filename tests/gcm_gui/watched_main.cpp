#include "support/handler_watch.h"
#include "support/run_tests.h"

/// The main function for tests that measure the handlers of the window.
int main(int argc, char** argv) {
  return tendon::gui::RunTests<tendon::gui::HandlerWatch>(argc, argv);
}
