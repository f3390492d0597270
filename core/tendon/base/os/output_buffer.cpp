#include <tendon/base/os/output_buffer.h>

#include <poll.h>
#include <sys/stat.h>
#include <tendon/base/os/termination.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstddef>

namespace tendon::os {
namespace {

constexpr std::size_t kEnough = std::size_t{1} << 16U;  // bytes to write at a time

/// Returns the number of bytes for one write. A pipe counts as writable only if it has room for
/// this many bytes. A file always has room.
std::size_t PieceFor(int descriptor) {
  struct stat status {};
  const bool is_file = fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
  return is_file ? kEnough : PIPE_BUF;
}

}  // namespace

OutputBuffer::OutputBuffer(int descriptor)
    : descriptor_(descriptor),
      piece_(PieceFor(descriptor)),
      is_terminal_(isatty(descriptor) == 1) {}

OutputBuffer::~OutputBuffer() { (void)WriteAll(); }

OutputBuffer::int_type OutputBuffer::overflow(int_type letter) {
  if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
  const char text = traits_type::to_char_type(letter);
  return Add({&text, 1}) ? letter : traits_type::eof();
}

std::streamsize OutputBuffer::xsputn(const char* text, std::streamsize size) {
  return Add({text, static_cast<std::size_t>(size)}) ? size : 0;
}

int OutputBuffer::sync() {
  ForgetInterruption();
  return WriteAll() ? 0 : -1;
}

/// Clears an EINTR failure if the program has continued since the termination request.
void OutputBuffer::ForgetInterruption() {
  if (failure_ == EINTR && !WasTerminationRequested()) failure_ = 0;
}

bool OutputBuffer::Add(std::string_view text) {
  ForgetInterruption();
  errno = failure_;
  if (failure_ != 0) return false;
  waiting_ += text;
  const bool is_line = is_terminal_ && text.find('\n') != text.npos;
  return (waiting_.size() < kEnough && !is_line) || WriteAll();
}

bool OutputBuffer::WriteAll() {
  std::size_t written = 0;
  while (failure_ == 0 && written < waiting_.size()) {
    if (!WaitForRoom()) {
      failure_ = EINTR;
      break;
    }
    const std::size_t size = std::min(piece_, waiting_.size() - written);
    const ssize_t some = write(descriptor_, waiting_.data() + written, size);
    if (some >= 0) written += static_cast<std::size_t>(some);
    if (some < 0 && errno != EINTR && errno != EAGAIN) failure_ = errno;
  }
  waiting_.clear();
  errno = failure_;
  return failure_ == 0;
}

bool OutputBuffer::WaitForRoom() const {
  constexpr int kLook = 20;  // ms between two checks for a request to terminate
  while (true) {
    pollfd wait{descriptor_, POLLOUT, 0};
    const int ready = poll(&wait, 1, 0);
    if (ready > 0) return true;  // if the pipe is broken, the next write reports it
    if (WasTerminationRequested()) return false;
    (void)poll(&wait, 1, kLook);
  }
}

}  // namespace tendon::os
