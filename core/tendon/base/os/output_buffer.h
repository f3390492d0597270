#pragma once

#include <cstddef>
#include <streambuf>
#include <string>
#include <string_view>

namespace tendon::os {

/// A stream buffer that writes to a descriptor whose reader may be slow, stopped or gone.
///
/// A write that must wait ends early if the process is asked to terminate, or was asked before
/// (WasTerminationRequested()). Then the rest of the text is not written, and the stream fails. If
/// the program continues nevertheless, it calls HoldTerminationSignals() and the stream's clear();
/// after that the stream works again. After any other failure, the stream fails permanently.
///
/// Writes to a terminal after each line. Writes to other descriptors when the stream is flushed, or
/// when 64 KiB are buffered. Thread safety: one thread at a time.
class OutputBuffer final : public std::streambuf {
 public:
  /// Does not own the descriptor.
  explicit OutputBuffer(int descriptor);
  OutputBuffer(const OutputBuffer&) = delete;
  OutputBuffer& operator=(const OutputBuffer&) = delete;
  /// Writes the text that is still buffered.
  ~OutputBuffer() override;

 protected:
  int_type overflow(int_type letter) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  /// Writes the buffered text. If an earlier write has failed, this function fails, too, with the
  /// errno of the first failed write. The errno is EINTR if the process was asked to terminate.
  int sync() override;

 private:
  [[nodiscard]] bool Add(std::string_view text);
  void ForgetInterruption();
  [[nodiscard]] bool WriteAll();
  /// Waits until a write does not block. Returns false if the process is asked to terminate.
  [[nodiscard]] bool WaitForRoom() const;

  const int descriptor_;
  const std::size_t piece_;  // bytes that never block when poll() reports room
  const bool is_terminal_;
  std::string waiting_;
  int failure_ = 0;  // errno of the first failed write; 0 if none
};

}  // namespace tendon::os
