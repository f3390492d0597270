#pragma once

#include <tendon/gcm/system_file.h>

#include <map>
#include <string>
#include <utility>

namespace tendon {

/// A process and a component in it.
using ComponentPath = std::pair<std::string, std::string>;

/// Returns the component that has the interface.
[[nodiscard]] inline ComponentPath OwnerOf(const InterfaceName& name) {
  return {name.process, name.component};
}

/// Finds parts of a system file in logarithmic time. The file must outlive the index, and its lists
/// must not change.
class SystemIndex {
 public:
  explicit SystemIndex(const SystemFile& system);

  // These functions return null if the file does not have the object.

  [[nodiscard]] const SystemFile::Process* FindProcess(const std::string& process) const;
  [[nodiscard]] const SystemFile::Component* FindComponent(const std::string& process,
                                                           const std::string& component) const;
  [[nodiscard]] const SystemFile::Connection* FindConnection(const InterfaceName& required) const;

 private:
  std::map<std::string, const SystemFile::Process*> processes_;
  std::map<ComponentPath, const SystemFile::Component*> components_;
  std::map<InterfaceName, const SystemFile::Connection*> connections_;
};

}  // namespace tendon
