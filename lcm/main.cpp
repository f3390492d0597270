#include <lcm/lcm_program.h>
#include <program/command_line.h>
#include <program/network_options.h>
#include <tendon/base/os/terminal.h>
#include <tendon/base/os/termination.h>

#include <CLI/CLI.hpp>
#include <iostream>

int main(int argc, char** argv) {
  tendon::os::GuardStreams();
  tendon::os::HoldTerminationSignals();
  lcm::Options options;
  int timeout_ms = static_cast<int>(options.timeout.count());

  CLI::App app("Runs the components of one process and joins a GCM.", "lcm");
  app.add_option("--name", options.name, "name of this process")->required();
  program::AddGcmOption(app, options.gcm);
  app.add_option("--system", options.system, "system file with this process' components");
  app.add_option("--listen", options.listen, "address for viewers and peers")
      ->capture_default_str();
  app.add_option("--advertise", options.advertise, "address to tell others, where it differs");
  app.add_option("--timeout", timeout_ms, "how long to look for the GCM at the start, in ms")
      ->check(CLI::Range(1, 3600000))
      ->capture_default_str();
  program::AddNetworkOptions(app, options.network);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::ParseError& mistake) {
    std::cerr << "lcm: " << program::SentenceOf(mistake, app, "lcm") << '\n';
    return program::kUsage;
  }
  options.timeout = std::chrono::milliseconds(timeout_ms);
  options.gcm = program::GcmAddress(options.gcm);
  return lcm::Run(options);
}
