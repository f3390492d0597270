#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace tendon {

/// Where the encoded answer of one call goes, so that a large one is written to where it is needed
/// and not copied there. Of one thread, which calls either function at most once.
class AnswerSink {
 public:
  AnswerSink() = default;
  AnswerSink(const AnswerSink&) = delete;
  AnswerSink& operator=(const AnswerSink&) = delete;
  virtual ~AnswerSink() = default;

  /// Room for an answer of `size` bytes, all of which the caller writes; empty where there is none
  /// for so many. May throw std::bad_alloc.
  virtual std::span<std::byte> Room(std::size_t size) = 0;
  /// Instead: an answer that lies elsewhere, as long as this runs. Unless overridden, copies it.
  virtual void Take(std::span<const std::byte> answer) {
    const std::span<std::byte> room = Room(answer.size());
    if (!room.empty()) std::ranges::copy(answer, room.begin());
  }
};

/// Replaces the content of bytes, which keep their capacity and live as long as this.
class BytesSink final : public AnswerSink {
 public:
  explicit BytesSink(std::vector<std::byte>& bytes) : bytes_(bytes) {}

  std::span<std::byte> Room(std::size_t size) override {
    bytes_.resize(size);
    return bytes_;
  }

 private:
  std::vector<std::byte>& bytes_;
};

}  // namespace tendon
