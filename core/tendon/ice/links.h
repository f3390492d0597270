#pragma once

#include <Ice/Ice.h>
#include <tendon/base/clock.h>
#include <tendon/ice/connection_socket.h>
#include <tendon/ice/ice_link.h>

#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>

namespace tendon::ice {

/// The links of one communicator. Thread-safe.
class Links {
 public:
  /// Adds a link. From now on, the link receives frames, and learns when its connection ends.
  static void Add(const std::shared_ptr<Links>& links, const std::shared_ptr<IceLink>& link);

  std::shared_ptr<IceLink> Find(const std::shared_ptr<Ice::Connection>& connection);
  std::shared_ptr<IceLink> Find(const SocketAddresses& addresses);

  /// Calls PendingCalls::ReleaseOld() of all links.
  void ReleaseOldCalls(SteadyTime now);

  /// Closes the links that `listener` has accepted. With 0, closes all links, including links that
  /// are added later. All calls of OnClosed() have returned before this function returns.
  void CloseAll(std::uint64_t listener);

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_shut_ = false;
  std::map<Ice::Connection*, std::shared_ptr<IceLink>> links_;
};

}  // namespace tendon::ice
