#include <tendon/base/os/loading/child_process.h>
#include <tendon/base/os/loading/shared_library.h>
#include <tendon/base/os/process.h>
#include <tendon/base/printable.h>
#include <tendon/manager/plugin.h>
#include <tendon/manager/plugin_abi.h>

#include <exception>

namespace tendon {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRegister = "TendonRegisterComponents";
constexpr const char* kAbi = "TendonPluginAbi";
constexpr const char* kLoads = "expected a library that loads, found that ";

Error Refusal(const fs::path& file, const std::string& reason) {
  return {ErrorCode::kFailed, "plug-in " + file.string() + ": " + reason};
}

/// What the exception that is being handled says.
std::string ThrownWords() { return "threw: " + Printable(ReasonOf(std::current_exception()), 512); }

Result<void> CheckAbi(void* library) {
  void* const symbol = os::FindSymbol(library, kAbi);
  if (symbol == nullptr) {
    return Error{ErrorCode::kFailed, std::string("expected the function ") + kAbi +
                                         ", found none; include component_registry.h in the file "
                                         "which registers"};
  }
  const std::uint64_t found = reinterpret_cast<std::uint64_t (*)()>(symbol)();
  if (found == TendonPluginAbi()) return {};
  return Error{ErrorCode::kFailed, "expected " + DescribePluginAbi(TendonPluginAbi()) + ", found " +
                                       DescribePluginAbi(found) +
                                       "; build it again against this version"};
}

fs::path ProbeProgram() {
  constexpr const char* kName = "tendon-probe";
  const fs::path library = os::FileOf(reinterpret_cast<const void*>(&OpenPlugin));
  for (const fs::path& folder :
       {os::ProgramFolder(), library.parent_path().parent_path() / "bin"}) {
    std::error_code ignored;
    if (fs::is_regular_file(folder / kName, ignored)) return folder / kName;
  }
  return {};
}

}  // namespace

std::string DescribePluginAbi(std::uint64_t abi) {
  const auto part = [abi](unsigned shift, std::uint64_t mask) {
    return std::to_string(abi >> shift & mask);
  };
  const std::string strings = (abi & 0xffU) == 1 ? "" : " with old strings";
  return "tendon " + part(48, 0xffff) + "." + part(32, 0xffff) + ", C++ ABI " + part(8, 0xffffff) +
         strings;
}

Result<ComponentRegistry> OpenPlugin(const fs::path& file) {
  void* library = nullptr;
  try {
    const auto loaded = os::LoadSharedLibrary(file);
    if (!loaded) return Refusal(file, loaded.error().message);
    library = *loaded;
  } catch (...) {
    return Refusal(file, kLoads + ("its start-up " + ThrownWords()));
  }
  void* const entry = os::FindSymbol(library, kRegister);
  if (entry == nullptr) {
    return Refusal(file, std::string("expected the function ") + kRegister +
                             ", found none; it is no plug-in with components");
  }
  if (auto checked = CheckAbi(library); !checked) return Refusal(file, checked.error().message);
  ComponentRegistry registry;
  try {
    reinterpret_cast<void (*)(ComponentRegistry&)>(entry)(registry);
  } catch (...) {
    return Refusal(
        file, std::string("expected ") + kRegister + " to return, found that it " + ThrownWords());
  }
  return registry;
}

Result<void> ProbePlugin(const fs::path& file, std::chrono::milliseconds patience) {
  if (auto checked = os::CheckSharedLibrary(file); !checked) {
    return Refusal(file, checked.error().message);
  }
  const fs::path program = ProbeProgram();
  if (program.empty()) return {};
  const auto outcome = os::RunProgram(program, {file.string()}, patience);
  if (!outcome) {
    if (outcome.error().code != ErrorCode::kTimeout) return outcome.error();
    return Refusal(
        file, kLoads + ("it has not finished after " + std::to_string(patience.count()) + " ms"));
  }
  // A plug-in may write, too, and end the process with any code.
  const std::string& out = outcome->out;
  const std::string last = out.substr(out.rfind('\n', out.size() - 2) + 1);
  if (outcome->exit_code == 0 && out.ends_with("loaded\n")) return {};
  if (outcome->exit_code == 1 && last.starts_with("plug-in ")) {
    return Error{ErrorCode::kFailed, last.substr(0, last.find('\n'))};
  }
  const std::string how =
      outcome->exit_code ? "exit code " + std::to_string(*outcome->exit_code) : outcome->signal;
  return Refusal(file, kLoads + ("it ends the process that loads it with " + how));
}

}  // namespace tendon
