#pragma once

#include <tendon/base/source_location.h>

#include <map>
#include <string>

namespace tendon {

/// The names of one interface's members. Each is added once, in the component's constructor.
class MemberNames {
 public:
  /// Adds a name. Throws ConfigurationError if the name is invalid, if it is already in use (the
  /// message says where it was added), or after Seal(). `what` is "command", "event", ...
  void Add(const std::string& what, const std::string& name, const std::string& interface,
           SourceLocation location);
  /// From now on, no name can be added.
  void Seal() { sealed_ = true; }

 private:
  bool sealed_ = false;
  std::map<std::string, SourceLocation> added_at_;
};

}  // namespace tendon
