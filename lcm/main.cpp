#include <lcm/lcm_program.h>
#include <program/command_line.h>
#include <program/network_options.h>
#include <tendon/base/os/terminal.h>
#include <tendon/base/os/termination.h>
#include <tendon/process/version_messages.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <iostream>

int main(int argc, char** argv) {
  tendon::os::GuardStreams();
  tendon::os::HoldTerminationSignals();
  lcm::Options options;
  int timeout_ms = static_cast<int>(options.timeout.count());
  double history_seconds = std::chrono::duration<double>(options.history.span).count();

  CLI::App app("Runs the components of one process and joins a GCM.", "lcm");
  app.add_option("--name", options.name, "name of this process")->required();
  program::AddGcmOption(app, options.gcm);
  app.add_option("--system", options.system, "system file with the components of this process");
  app.add_option("--listen", options.listen,
                 "address at which this process listens for viewers and other processes")
      ->capture_default_str();
  app.add_option("--advertise", options.advertise,
                 "address that other processes use to connect; if it has no port, the port of "
                 "--listen is used (default: the address of --listen; if that is 0.0.0.0 or [::], "
                 "the address from which this process reaches the GCM)");
  app.set_version_flag("--version", "lcm " + tendon::OwnVersion().release);
  app.add_option("--timeout", timeout_ms,
                 "maximum time to wait for the GCM at the start: 500ms, 5s, 2min or a number of ms")
      ->type_name("TIME")
      ->transform(CLI::Validator(&program::TransformMilliseconds, ""))
      ->default_str("3s");
  app.add_option(
         "--history-memory", options.history.memory,
         "memory for the history of this process, which gcm save-last saves: 64MiB, 1GiB; 0 "
         "keeps nothing")
      ->type_name("SIZE")
      ->transform(CLI::AsSizeValue(false))
      ->default_str("32MiB");
  app.add_option("--history-time", history_seconds, "length of the history: 30s, 2min")
      ->type_name("TIME")
      ->transform(CLI::Validator(&program::TransformDuration, ""))
      ->default_str("30s");
  program::AddNetworkOptions(app, options.network);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    const int exit_code = app.exit(asked);
    if (std::cout.flush()) return exit_code;
    std::cerr << "lcm: cannot write the output: the disk is full, or the output is closed\n";
    return program::kRefused;
  } catch (const CLI::ParseError& mistake) {
    std::cerr << "lcm: " << program::SentenceOf(mistake, app, "lcm") << '\n';
    return program::kUsage;
  }
  options.timeout = std::chrono::milliseconds(timeout_ms);
  constexpr std::chrono::duration<double> kLongestHistory = std::chrono::hours(24);
  options.history.span = std::chrono::duration_cast<std::chrono::nanoseconds>(
      std::min(std::chrono::duration<double>(history_seconds), kLongestHistory));
  options.gcm = program::GcmAddress(options.gcm);
  return lcm::Run(options);
}
