#include <program/lcm_launch.h>
#include <tendon/base/os/process.h>

#include <filesystem>
#include <string>
#include <vector>

namespace program {
namespace {

std::vector<std::string> Words(const NetworkOptions& options, const std::string& process) {
  std::vector<std::string> words = {"--middleware", options.middleware};
  if (options.insecure) words.emplace_back("--insecure");
  if (options.certificate.empty()) return words;
  const auto folder = std::filesystem::path(options.certificate).parent_path();
  words.insert(words.end(), {"--certificate", (folder / (process + ".crt")).string(), "--ca",
                             AuthorityOf(options).string()});
  return words;
}

}  // namespace

tendon::Launch LcmLaunch(const NetworkOptions& options) {
  return {.program = tendon::os::ProgramFolder() / "lcm",
          .options = [options](const std::string& process) { return Words(options, process); }};
}

}  // namespace program
