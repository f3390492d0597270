#pragma once

#include <tendon/base/source_place.h>

#include <map>
#include <string>

namespace tendon {

/// The names of one interface's members: each is given once, in the component's constructor.
class MemberNames {
 public:
  /// ConfigurationError where the name is bad, taken or too late; it says where it was given first.
  /// `what` is "command", "event", ...
  void Add(const std::string& what, const std::string& name, const std::string& interface,
           SourcePlace place);
  /// From now on it is too late.
  void Seal() { sealed_ = true; }

 private:
  bool sealed_ = false;
  std::map<std::string, SourcePlace> added_at_;
};

}  // namespace tendon
