#pragma once

#include <tendon/middleware/middleware.h>

#include <cstdint>

namespace tendon {

class Channel;

/// The request that this thread is being asked by a peer, as long as it lives: where its answer can
/// be left (LinkHandler::OnAsked()). One at a time in a thread.
class Asked {
 public:
  Asked(const Channel& channel, std::uint64_t request, LeftAnswer& answer);
  Asked(const Asked&) = delete;
  Asked& operator=(const Asked&) = delete;
  ~Asked();

  /// Where this thread may leave the answer to `request`; null where it must be sent.
  [[nodiscard]] static LeftAnswer* AnswerTo(std::uint64_t request, const Channel& channel);
  /// Where it has begun one; null where it has not.
  [[nodiscard]] static LeftAnswer* Begun(std::uint64_t request, const Channel& channel);

 private:
  /// Null where it is not what this thread is asked.
  static LeftAnswer* Find(std::uint64_t request, const Channel& channel);

  const Channel& channel_;
  const std::uint64_t request_;
  LeftAnswer& answer_;
};

}  // namespace tendon
