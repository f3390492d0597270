#pragma once

#include <cstddef>
#include <streambuf>
#include <string>
#include <string_view>

namespace tendon::os {

/// Writes a stream to a descriptor whose reader may be slow, stopped or gone. If a write has to
/// wait and the process is, or was, asked to end (WasTerminationRequested()), it stops waiting: the
/// rest is not written, and the stream fails until the program goes on (HoldTerminationSignals()
/// and clear() of the stream). After any other failure the stream fails permanently.
///
/// Writes to a terminal at once; elsewhere when the stream is flushed or has 64 KiB. Thread safety:
/// one thread at a time.
class OutputBuffer final : public std::streambuf {
 public:
  /// Does not own the descriptor.
  explicit OutputBuffer(int descriptor);
  OutputBuffer(const OutputBuffer&) = delete;
  OutputBuffer& operator=(const OutputBuffer&) = delete;
  /// Writes the buffered rest.
  ~OutputBuffer() override;

 protected:
  int_type overflow(int_type letter) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  /// Fails with the errno of the first failed write; EINTR if it was asked to end.
  int sync() override;

 private:
  [[nodiscard]] bool Add(std::string_view text);
  void ForgetInterruption();
  [[nodiscard]] bool WriteAll();
  /// False if the process is asked to terminate.
  [[nodiscard]] bool WaitForRoom() const;

  const int descriptor_;
  const std::size_t piece_;  // bytes that can be written without waiting once poll() reports room
  const bool is_terminal_;
  std::string waiting_;
  int failure_ = 0;  // errno
};

}  // namespace tendon::os
