#pragma once

#include <tendon/middleware/middleware.h>

#include <cstdint>

namespace tendon {

class Channel;

/// While it lives, this thread handles `request`, whose reply may be written to `answer`
/// (LinkHandler::OnAsked()). One object at a time in a thread.
class Asked {
 public:
  Asked(const Channel& channel, std::uint64_t request, ReplySlot& answer);
  Asked(const Asked&) = delete;
  Asked& operator=(const Asked&) = delete;
  ~Asked();

  /// The slot in which this thread may write the reply to `request`; null if the reply must be sent
  /// as a message.
  [[nodiscard]] static ReplySlot* AnswerTo(std::uint64_t request, const Channel& channel);
  /// The same slot if the reply was begun there; otherwise null.
  [[nodiscard]] static ReplySlot* Begun(std::uint64_t request, const Channel& channel);

 private:
  /// Null if this thread does not handle `request`.
  static ReplySlot* Find(std::uint64_t request, const Channel& channel);

  const Channel& channel_;
  const std::uint64_t request_;
  ReplySlot& answer_;
};

}  // namespace tendon
