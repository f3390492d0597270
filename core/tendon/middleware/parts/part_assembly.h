#pragma once

#include <tendon/middleware/frame.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>

namespace tendon {

/// Puts together what a peer sends in parts (parts/part_sender.h). A peer has so much on its way at
/// a time as a PartSender lets it, and no more is kept for it: whoever claims more sends nonsense.
/// Not thread-safe.
class PartAssembly {
 public:
  /// What a part has led to.
  enum class Progress {
    kMoreToCome,
    kWhole,  ///< a frame is whole
    /// No part of a frame that the peer may send, or no memory for it; the link is to be closed.
    kNonsense
  };
  /// What has been put together; it belongs to who has asked.
  struct Frame {
    FrameHeader header;
    Bytes body;
  };
  /// `number` tells the frames apart that come at one time; `frame` is set where one is whole.
  Progress Add(std::uint32_t number, std::span<const std::byte> part, Frame& frame);

  /// Bytes that have come since the link stands.
  [[nodiscard]] std::uint64_t taken() const { return taken_; }
  /// Bytes that are kept for frames that have begun, or will be.
  [[nodiscard]] std::size_t claimed() const { return claimed_; }
  /// Frees what has begun, and will not be whole.
  void Clear();

 private:
  Frame* Begin(std::uint32_t number, std::span<const std::byte> part);

  std::map<std::uint32_t, Frame> begun_;
  std::size_t claimed_ = 0;
  std::uint64_t taken_ = 0;
};

}  // namespace tendon
