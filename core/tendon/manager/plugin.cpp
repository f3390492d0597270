#include <tendon/manager/plugin.h>

#include <tendon/base/os/child_process.h>
#include <tendon/base/os/library_copy.h>
#include <tendon/base/os/process.h>
#include <tendon/base/os/shared_library.h>
#include <tendon/base/text.h>
#include <tendon/manager/plugin_abi.h>

#include <array>
#include <exception>
#include <map>
#include <mutex>
#include <utility>

namespace tendon {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRegister = "TendonRegisterComponents";
constexpr const char* kAbi = "TendonPluginAbi";
constexpr const char* kCannotLoad = "the library cannot be loaded: ";

Error LoadError(const fs::path& file, const std::string& reason) {
  return {ErrorCode::kFailed, "plug-in " + file.string() + ": " + reason};
}

/// Returns a text with the message of the current exception. Must be called in a catch block.
std::string ThrownWords() { return "threw: " + Printable(ReasonOf(std::current_exception()), 512); }

Result<void> CheckAbi(void* library) {
  void* const symbol = os::FindSymbol(library, kAbi);
  if (symbol == nullptr) {
    return Error{ErrorCode::kFailed, std::string("expected the function ") + kAbi +
                                         ", found none; include component_registry.h in the file "
                                         "that registers the components"};
  }
  const std::uint64_t found = reinterpret_cast<std::uint64_t (*)()>(symbol)();
  if (found == TendonPluginAbi()) return {};
  return Error{ErrorCode::kFailed, "expected " + DescribePluginAbi(TendonPluginAbi()) + ", found " +
                                       DescribePluginAbi(found) +
                                       "; build the plug-in again against this version of Tendon"};
}

/// Identifies a library by its path and the hash of its content. A file with new content is
/// therefore another library.
using LoadedFile = std::pair<fs::path, std::array<std::uint64_t, 2>>;
std::mutex loaded_mutex;
std::map<LoadedFile, void*>& LoadedLibraries() {
  static std::map<LoadedFile, void*> libraries;
  return libraries;
}

Result<void*> LoadGuarded(const fs::path& file, const fs::path& original) {
  try {
    const auto loaded = os::LoadSharedLibrary(file, original);
    return loaded ? loaded : LoadError(original, loaded.error().message);
  } catch (...) {
    return LoadError(original, kCannotLoad + ("its start-up " + ThrownWords()));
  }
}

/// Lets a loaded library register its classes.
Result<ComponentRegistry> LetRegister(void* library, const fs::path& original) {
  void* const entry = os::FindSymbol(library, kRegister);
  if (entry == nullptr) {
    return LoadError(original, std::string("expected the function ") + kRegister +
                                   ", found none: either the file is not a plug-in, or "
                                   "-fvisibility=hidden or a missing extern \"C\" hides the "
                                   "function; define it outside of any namespace, and include "
                                   "tendon/manager/component_registry.h");
  }
  if (auto checked = CheckAbi(library); !checked)
    return LoadError(original, checked.error().message);
  ComponentRegistry registry;
  try {
    reinterpret_cast<void (*)(ComponentRegistry&)>(entry)(registry);
  } catch (...) {
    return LoadError(original,
                     std::string("expected ") + kRegister + " to return, but it " + ThrownWords());
  }
  return registry;
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
  const std::string strings = (abi & 1U) != 0 ? "" : " with old strings";
  const std::string containers = (abi & 2U) != 0 ? " with debug containers" : "";
  return "tendon " + part(48, 0xffff) + "." + part(32, 0xffff) + ", C++ ABI " + part(8, 0xffffff) +
         strings + containers;
}

Result<Plugin> LoadPlugin(const fs::path& file, std::chrono::milliseconds timeout) {
  auto copy = os::LibraryCopy::Make(file);
  if (!copy) return LoadError(file, copy.error().message);
  Plugin plugin{.registry = {}, .content = (*copy)->content()};
  const std::scoped_lock lock(loaded_mutex);
  void*& library = LoadedLibraries()[{plugin.content.file, plugin.content.hash}];
  if (library == nullptr) {
    if (auto probed = ProbePlugin((*copy)->path(), file, timeout); !probed) return probed.error();
    const auto loaded = LoadGuarded((*copy)->path(), file);
    if (!loaded) return loaded.error();
    library = *loaded;
    os::LibraryCopy::Keep(*std::move(copy));
  }
  auto registry = LetRegister(library, file);
  if (!registry) return registry.error();
  plugin.registry = *std::move(registry);
  return plugin;
}

Result<ComponentRegistry> OpenPlugin(const fs::path& file, const fs::path& original) {
  const auto library = LoadGuarded(file, original);
  return library ? LetRegister(*library, original) : library.error();
}

Result<void> ProbePlugin(const fs::path& file, const fs::path& original,
                         std::chrono::milliseconds timeout) {
  if (auto checked = os::CheckSharedLibrary(file); !checked) {
    return LoadError(original, checked.error().message);
  }
  const fs::path program = ProbeProgram();
  if (program.empty()) return {};
  const auto outcome = os::RunProgram(program, {file.string(), original.string()}, timeout);
  if (!outcome) {
    if (outcome.error().code != ErrorCode::kTimeout) return outcome.error();
    return LoadError(original,
                     kCannotLoad + ("loading it has not finished after " + Milliseconds(timeout)));
  }
  // The output is checked too, because the plug-in itself may print text or end the process with
  // any exit code.
  const std::string& out = outcome->out;
  const std::string last = out.substr(out.rfind('\n', out.size() - 2) + 1);
  if (outcome->exit_code == 0 && out.ends_with("loaded\n")) return {};
  if (outcome->exit_code == 1 && last.starts_with("plug-in ")) {
    return Error{ErrorCode::kFailed, last.substr(0, last.find('\n'))};
  }
  const std::string how =
      outcome->exit_code ? "exit code " + std::to_string(*outcome->exit_code) : outcome->signal;
  return LoadError(original, kCannotLoad + ("loading it ends the process with " + how));
}

}  // namespace tendon
