#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>
#include <utility>

namespace tendon::gui {

/// Passes the output of one thread to another. If kMaxWaiting bytes have not been taken yet, the
/// writer blocks, so that no output is lost and memory use is limited.
class OutputPipe {
 public:
  static constexpr std::size_t kMaxWaiting = std::size_t{1} << 20;  // bytes
  static constexpr std::size_t kMaxTaken = std::size_t{1} << 15;    // per call

  enum class Kind { kOut, kError };
  struct Piece {
    Kind kind;
    std::string text;
  };

  /// The writing thread calls `wake` when take() has output again.
  explicit OutputPipe(std::function<void()> wake) : wake_(std::move(wake)) {}

  /// Appends output, and blocks while the pipe is full. Returns false if the pipe is closed.
  bool write(Kind kind, std::string_view text);
  /// Removes and returns at most kMaxTaken bytes, which may end in the middle of a character. If
  /// more bytes remain, calls `wake` again.
  [[nodiscard]] std::deque<Piece> take();
  /// Discards the output that was not taken, and unblocks the writers.
  void close();
  [[nodiscard]] bool isEmpty();

 private:
  std::function<void()> wake_;
  std::mutex mutex_;
  std::condition_variable room_;
  std::deque<Piece> pieces_;
  std::size_t size_ = 0;
  bool is_woken_ = false;
  bool is_closed_ = false;
};

/// A stream that writes to a pipe.
class PipeStream : public std::ostream {
 public:
  PipeStream(OutputPipe& pipe, OutputPipe::Kind kind) : std::ostream(nullptr), buffer_(pipe, kind) {
    rdbuf(&buffer_);
  }

 private:
  class Buffer final : public std::streambuf {
   public:
    Buffer(OutputPipe& pipe, OutputPipe::Kind kind) : pipe_(pipe), kind_(kind) {}

   protected:
    int_type overflow(int_type letter) override;
    std::streamsize xsputn(const char* text, std::streamsize size) override;

   private:
    OutputPipe& pipe_;
    const OutputPipe::Kind kind_;
  };

  Buffer buffer_;
};

}  // namespace tendon::gui
