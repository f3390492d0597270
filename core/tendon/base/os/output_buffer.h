#pragma once

#include <cstddef>
#include <streambuf>
#include <string>
#include <string_view>

namespace tendon::os {

/// Writes a stream to a descriptor whose reader may be slow, stopped, or away. Where a write has to
/// wait and somebody asks the process to end, or has done so (WasTerminationAsked()), it waits no
/// longer: what is left is not written, and the stream fails, then and ever after.
///
/// To a terminal it writes at once, elsewhere when it is flushed or has enough. Thread safety: one
/// thread at a time.
class OutputBuffer final : public std::streambuf {
 public:
  /// Does not own the descriptor.
  explicit OutputBuffer(int descriptor);
  OutputBuffer(const OutputBuffer&) = delete;
  OutputBuffer& operator=(const OutputBuffer&) = delete;
  /// Writes what is left.
  ~OutputBuffer() override;

 protected:
  int_type overflow(int_type letter) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  /// Fails with the errno of the write that failed first.
  int sync() override;

 private:
  [[nodiscard]] bool Add(std::string_view text);
  [[nodiscard]] bool WriteAll();
  /// False where somebody asks the process to end.
  [[nodiscard]] bool WaitForRoom() const;

  const int descriptor_;
  const std::size_t piece_;  // bytes that never have to wait once there is room
  const bool is_terminal_;
  std::string waiting_;
  int failure_ = 0;  // errno
};

}  // namespace tendon::os
