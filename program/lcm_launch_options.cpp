#include <program/lcm_launch_options.h>

#include <tendon/base/os/process.h>

#include <filesystem>
#include <string>
#include <vector>

namespace program {
namespace {

std::vector<std::string> ProgramArguments(const NetworkOptions& options,
                                          const std::string& process) {
  std::vector<std::string> arguments = {"--middleware", options.middleware};
  if (options.insecure) arguments.emplace_back("--insecure");
  if (options.certificate.empty()) return arguments;
  const auto folder = std::filesystem::path(options.certificate).parent_path();
  arguments.insert(arguments.end(), {"--certificate", (folder / (process + ".crt")).string(),
                                     "--ca", AuthorityOf(options).string()});
  return arguments;
}

}  // namespace

tendon::LaunchOptions LcmLaunchOptions(const NetworkOptions& options) {
  return {.program = tendon::os::ProgramFolder() / "lcm",
          .options = [options](const std::string& process) {
            return ProgramArguments(options, process);
          }};
}

}  // namespace program
