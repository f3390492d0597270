#pragma once

#include <tendon/gcm/catalog.h>
#include <tendon/process/membership_messages.h>

#include <string>
#include <vector>

namespace tendon::server {

/// The connections of processes that are gone, which they get back when they return and both ends
/// are there again. Not thread-safe.
class HandBacks {
 public:
  /// Keeps the connections which the process owns now, besides those it was not given back yet.
  void Keep(const Catalog& catalog, const std::string& process);
  void Drop(const std::string& process);

  /// Those that can be made again now, and are forgotten here. One whose end has returned with
  /// another class, or whose required interface was connected meanwhile, is forgotten silently.
  std::vector<message::Wire> TakeDue(const Catalog& catalog);

 private:
  enum class Readiness { kWaiting, kDue, kPointless };
  struct Kept {
    message::Wire wire;
    std::string required_class;
    std::string provided_class;  ///< empty: was not known
  };

  static Readiness Judge(const Kept& kept, const Catalog& catalog);

  std::vector<Kept> kept_;
};

}  // namespace tendon::server
