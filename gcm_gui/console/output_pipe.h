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

namespace tendon::gui {

/// What a thread writes, until another one takes it. A writer who is far ahead waits, so that
/// nothing is lost and little is kept.
class OutputPipe {
 public:
  static constexpr std::size_t kMostWaiting = std::size_t{1} << 20;  // bytes
  static constexpr std::size_t kMostTaken = std::size_t{1} << 15;    // at one go

  enum class Kind { kOut, kError };
  struct Piece {
    Kind kind;
    std::string text;
  };

  /// `wake` is called by the writer when there is something to take again.
  explicit OutputPipe(std::function<void()> wake) : wake_(std::move(wake)) {}

  /// False once it is closed.
  bool write(Kind kind, std::string_view text);
  /// At most kMostTaken bytes, which may end within a letter; wakes again where there are more.
  [[nodiscard]] std::deque<Piece> take();
  /// What waits is thrown away, and no writer waits any more.
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

/// A stream into a pipe.
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
