#include <tendon/process/lifecycle/component_factory.h>

#include <tendon/payload/json.h>
#include <tendon/payload/json/strict_json.h>
#include <tendon/task/threaded_task.h>

#include <nlohmann/json.hpp>
#include <vector>

namespace tendon {
namespace {

using message::LifecycleOrder;

/// Converts valid JSON to one line of ASCII, as used in catalogues and files.
std::string Compact(const std::string& json) {
  if (json.empty()) return json;
  const auto parsed = ParseStrictJson(json);
  return parsed ? parsed->dump(-1, ' ', true) : json;
}

Result<void> SetThread(const LifecycleOrder& order, Component& component) {
  if (order.thread.empty()) return {};
  const auto options = FromJson<ThreadOptions>(order.thread);
  auto* const task = dynamic_cast<ThreadedTask*>(&component);
  if (!options) return options.error();
  if (task == nullptr) {
    return Error{ErrorCode::kInvalid,
                 "component '" + component.name() +
                     "' has no thread of its own, so it takes no thread options"};
  }
  try {
    task->SetThreadOptions(*options);
    return {};
  } catch (const ConfigurationError& error) {
    return Error{ErrorCode::kInvalid, error.what()};
  }
}

}  // namespace

Result<void> ComponentFactory::Load(const std::string& library, const Begin& begin) {
  if (!loader_) return NoLoader();
  const std::scoped_lock lock(mutex_);
  if (auto begun = begin(); !begun) return begun;
  loader_->files()->Update();  // updates the states of loaded plug-ins
  return loader_->Load(library);
}

Result<ComponentFactory::CreatedParts> ComponentFactory::Make(const LifecycleOrder& order,
                                                              const Begin& begin) {
  if (!loader_) return NoLoader();
  const std::string configuration = Compact(order.configuration);
  if (configuration.size() > message::kLongestConfiguration) {
    return Error{ErrorCode::kInvalid,
                 "the configuration of '" + order.component + "' has " +
                     std::to_string(configuration.size()) + " bytes; at most " +
                     std::to_string(message::kLongestConfiguration) + " are allowed"};
  }
  const std::scoped_lock lock(mutex_);
  if (auto begun = begin(); !begun) return begun.error();
  std::string library = order.library;
  if (library.empty()) {
    const auto found = LibraryOf(order.class_name);
    if (!found) return found.error();
    library = *found;
  }
  loader_->files()->Update();
  auto component = loader_->Create(library, order.class_name, order.component, order.configuration);
  if (!component) return component.error();
  if (auto set = SetThread(order, **component); !set) return set.error();
  return CreatedParts{
      *std::move(component),
      {.class_name = order.class_name, .library = library, .configuration = configuration}};
}

message::Classes ComponentFactory::classes() {
  message::Classes all;
  if (!loader_) return all;
  const std::scoped_lock lock(mutex_);
  for (const auto& [library, registry] : loader_->loaded()) {
    for (const ComponentClass& one : registry.classes()) {
      all.classes.push_back({.name = one.name,
                             .library = library,
                             .configuration = one.configuration.TextWithHelp(),
                             .defaults = one.defaults});
    }
  }
  all.plugins = loader_->available();
  loader_->files()->Update();
  all.loaded = loader_->files()->descriptions();
  return all;
}

std::shared_ptr<PluginFiles> ComponentFactory::files() const {
  return loader_ ? loader_->files() : nullptr;
}

Result<std::string> ComponentFactory::LibraryOf(const std::string& class_name) const {
  std::vector<std::string> libraries;
  std::vector<std::string> classes;
  for (const auto& [library, registry] : loader_->loaded()) {
    for (const std::string& name : registry.class_names()) {
      classes.push_back(name);
      if (name == class_name) libraries.push_back(library);
    }
  }
  if (libraries.size() == 1) return libraries.front();
  if (libraries.empty()) {
    return Error{ErrorCode::kNotFound,
                 "no library that process '" + process_ + "' has loaded has a class '" +
                     class_name + "'" + DidYouMean(class_name, classes) +
                     "; load the library that has this class, or give the name of that library"};
  }
  return Error{ErrorCode::kInvalid, "the libraries '" + libraries[0] + "' and '" + libraries[1] +
                                        "' both have a class '" + class_name +
                                        "'; give the name of the library to use"};
}

Error ComponentFactory::NoLoader() const {
  return {ErrorCode::kFailed, "process '" + process_ +
                                  "' cannot create components on request, because its program "
                                  "does not load plug-ins; the program lcm does"};
}

}  // namespace tendon
