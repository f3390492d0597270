#include <QApplication>

#include "support/run_tests.h"

int main(int argc, char** argv) { return tendon::gui::RunTests<QApplication>(argc, argv); }
