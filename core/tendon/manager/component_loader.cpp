#include <tendon/manager/component_loader.h>

#include <tendon/base/name.h>
#include <tendon/base/os/process.h>
#include <tendon/base/text.h>
#include <tendon/manager/plugin.h>

#include <cstdlib>
#include <set>

namespace tendon {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> Plugins(const std::vector<fs::path>& folders) {
  std::set<std::string> names;
  for (const fs::path& folder : folders) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
      if (entry.path().extension() == ".so") names.insert(entry.path().stem().string());
    }
  }
  return {names.begin(), names.end()};
}

}  // namespace

ComponentLoader::ComponentLoader(std::vector<fs::path> folders) {
  if (const char* list = std::getenv("TENDON_COMPONENTS")) {  // NOLINT(concurrency-mt-unsafe)
    std::string_view rest = list;
    while (!rest.empty()) {
      const std::size_t end = rest.find(':');
      if (end != 0) folders_.emplace_back(rest.substr(0, end));
      rest = end == rest.npos ? std::string_view() : rest.substr(end + 1);
    }
  }
  folders_.insert(folders_.end(), folders.begin(), folders.end());
  folders_.push_back(
      (os::ProgramFolder() / ".." / "lib" / "tendon" / "components").lexically_normal());
}

Result<void> ComponentLoader::Load(const std::string& library) {
  if (loaded_.contains(library)) return {};
  const auto file = Find(library);
  if (!file) return file.error();
  auto plugin = LoadPlugin(*file);
  if (!plugin) return plugin.error();
  loaded_.emplace(library, std::move(plugin->registry));
  files_->Add(library, std::move(plugin->content));
  return {};
}

Result<std::unique_ptr<Component>> ComponentLoader::Create(const std::string& library,
                                                           const std::string& class_name,
                                                           const std::string& name,
                                                           const std::string& configuration_json) {
  if (auto loaded = Load(library); !loaded) return loaded.error();
  auto component = loaded_.at(library).Create(class_name, name, configuration_json);
  if (component) return component;
  return Error{component.error().code, component.error().message + " (plug-in " + library + ".so)"};
}

std::vector<std::string> ComponentLoader::available() const { return Plugins(folders_); }

Result<fs::path> ComponentLoader::Find(const std::string& library) const {
  if (auto checked = CheckName("plug-in", library); !checked) return checked.error();
  for (const fs::path& folder : folders_) {
    const fs::path file = folder / (library + ".so");
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored)) return file;
  }
  return Error{ErrorCode::kNotFound,
               "no plug-in '" + library + "'" + DidYouMean(library, Plugins(folders_)) +
                   " (searched " +
                   Joined(std::vector<std::string>(folders_.begin(), folders_.end()), ", ") +
                   "; set TENDON_COMPONENTS to add a folder)"};
}

}  // namespace tendon
