#pragma once

#include <tendon/manager/component_loader.h>
#include <tendon/manager/local_manager.h>
#include <tendon/process/life/messages.h>

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace tendon {

/// Makes components of the classes of plug-ins, as orders say; one after the other, for plug-ins
/// may know nothing of threads. Thread-safe.
class ComponentMaker {
 public:
  /// Called once it is one's turn: whether the order is still to be carried out.
  using Begin = std::function<Result<void>()>;
  /// A component, not yet in its process.
  struct Made {
    std::unique_ptr<Component> component;
    ComponentOrigin origin;
  };

  /// `loader` is nobody else's from now on; null: there is none, and every order is refused.
  ComponentMaker(std::string process, std::shared_ptr<ComponentLoader> loader)
      : process_(std::move(process)), loader_(std::move(loader)) {}

  Result<void> Load(const std::string& library, const Begin& begin);
  Result<Made> Make(const message::LifeOrder& order, const Begin& begin);
  [[nodiscard]] message::Classes classes();
  /// The files of its plug-ins; null where there is no loader.
  [[nodiscard]] std::shared_ptr<PluginFiles> files() const;

 private:
  [[nodiscard]] Result<std::string> LibraryOf(const std::string& class_name) const;
  [[nodiscard]] Error NoLoader() const;

  const std::string process_;
  const std::shared_ptr<ComponentLoader> loader_;
  std::mutex mutex_;  // of what the loader knows, and does
};

}  // namespace tendon
