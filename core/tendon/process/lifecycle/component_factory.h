#pragma once

#include <tendon/manager/component_loader.h>
#include <tendon/manager/local_manager.h>
#include <tendon/process/lifecycle/lifecycle_messages.h>

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace tendon {

/// Creates components from the classes of plug-ins, one at a time, because plug-ins need not be
/// thread-safe. Thread-safe.
class ComponentFactory {
 public:
  /// Called just before the order is executed. An error cancels the order.
  using Begin = std::function<Result<void>()>;
  /// A new component that was not added to its process yet.
  struct CreatedParts {
    std::unique_ptr<Component> component;
    ComponentOrigin origin;
  };

  /// `loader` must not be used by other code from now on. If it is null, every order is refused.
  ComponentFactory(std::string process, std::shared_ptr<ComponentLoader> loader)
      : process_(std::move(process)), loader_(std::move(loader)) {}

  Result<void> Load(const std::string& library, const Begin& begin);
  Result<CreatedParts> Make(const message::LifecycleOrder& order, const Begin& begin);
  [[nodiscard]] message::Classes classes();
  /// The files of the loaded plug-ins; null without a loader.
  [[nodiscard]] std::shared_ptr<PluginFiles> files() const;

 private:
  [[nodiscard]] Result<std::string> LibraryOf(const std::string& class_name) const;
  [[nodiscard]] Error NoLoader() const;

  const std::string process_;
  const std::shared_ptr<ComponentLoader> loader_;
  std::mutex mutex_;  // guards the loader
};

}  // namespace tendon
