#include <tendon/manager/plugin.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

/// tendon-probe FILE [ORIGINAL]: tests a plug-in. Loads it like the other programs, prints "loaded"
/// or the error, and exits with 0 or 1. FILE is a copy of ORIGINAL. If the plug-in crashes, only
/// this process is affected.
namespace {

std::string plugin;  // for the terminate handler, which takes no argument

[[noreturn]] void End(int code, const std::string& last_words) {
  std::printf("\n%s\n", last_words.c_str());
  std::fflush(stdout);
  std::_Exit(code);  // skips the plug-in's destructors
}

[[noreturn]] void OnTerminate() {
  const auto thrown = std::current_exception();
  End(1, "plug-in " + plugin + ": the library cannot be loaded: " +
             (thrown ? "its start-up threw: " + tendon::ReasonOf(thrown) : "it ends the process"));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::fputs("usage: tendon-probe FILE [ORIGINAL]\n", stderr);
    return 2;
  }
  plugin = argv[argc - 1];
  std::set_terminate(OnTerminate);
  const auto opened = tendon::OpenPlugin(argv[1], plugin);
  if (!opened) End(1, opened.error().message);
  End(0, "loaded");
}
