#pragma once

#include <tendon/base/error.h>
#include <tendon/middleware/channel.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace tendon {

/// A viewer's subscription to a stream.
struct RowViewer {
  std::shared_ptr<Channel> channel;
  std::uint32_t handle = 0;
  Lane lane = kCommonLane;  ///< lane for the viewer's rows
};

/// Notifies the viewer that its rows have ended. Closes the viewer's channel if the notice cannot
/// be sent.
void ReportEnd(const RowViewer& viewer, const Error& reason);

/// The viewers of one stream or topic. The state of one viewer has the type `Viewer`, which is
/// RowViewer or derived from RowViewer.
///
/// One thread at a time.
template <std::derived_from<RowViewer> Viewer>
class ViewerList {
 public:
  void Add(Viewer viewer) { viewers_.push_back(std::move(viewer)); }
  void Remove(const Channel& channel, std::uint32_t handle) {
    std::erase_if(viewers_, [&](const Viewer& viewer) {
      return viewer.channel.get() == &channel && viewer.handle == handle;
    });
  }
  void RemoveClosed() {
    std::erase_if(viewers_, [](const Viewer& viewer) { return !viewer.channel->is_open(); });
  }
  /// Reports the end to all viewers and removes them. If a report cannot be sent, closes the
  /// channel of the viewer.
  void EndAll(const Error& reason) {
    for (const Viewer& viewer : viewers_) ReportEnd(viewer, reason);
    viewers_.clear();
  }

  [[nodiscard]] bool empty() const { return viewers_.empty(); }
  [[nodiscard]] std::size_t CountOf(const Channel& channel) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        viewers_, [&](const Viewer& viewer) { return viewer.channel.get() == &channel; }));
  }
  [[nodiscard]] auto begin() { return viewers_.begin(); }
  [[nodiscard]] auto end() { return viewers_.end(); }
  [[nodiscard]] auto begin() const { return viewers_.begin(); }
  [[nodiscard]] auto end() const { return viewers_.end(); }

 private:
  std::vector<Viewer> viewers_;
};

}  // namespace tendon
