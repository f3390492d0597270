#include <gcm_gui/console/output_pipe.h>

#include <algorithm>
#include <utility>

namespace tendon::gui {

bool OutputPipe::write(Kind kind, std::string_view text) {
  bool wakes = false;
  {
    std::unique_lock lock(mutex_);
    room_.wait(lock, [this] { return size_ < kMaxWaiting || is_closed_; });
    if (is_closed_) return false;
    const bool goes_on =
        !pieces_.empty() && pieces_.back().kind == kind && pieces_.back().text.size() < kMaxTaken;
    if (goes_on) {
      pieces_.back().text += text;
    } else {
      pieces_.push_back({kind, std::string(text)});
    }
    size_ += text.size();
    wakes = !std::exchange(is_woken_, true);
  }
  if (wakes) wake_();
  return true;
}

std::deque<OutputPipe::Piece> OutputPipe::take() {
  std::deque<Piece> taken;
  bool wakes = false;
  {
    const std::scoped_lock lock(mutex_);
    std::size_t size = 0;
    while (!pieces_.empty() && size < kMaxTaken) {
      Piece& front = pieces_.front();
      const std::size_t part = std::min(front.text.size(), kMaxTaken - size);
      size += part;
      if (part == front.text.size()) {
        taken.push_back(std::move(front));
        pieces_.pop_front();
      } else {
        taken.push_back({front.kind, front.text.substr(0, part)});
        front.text.erase(0, part);
      }
    }
    size_ -= size;
    is_woken_ = wakes = !pieces_.empty();
    room_.notify_all();
  }
  if (wakes) wake_();
  return taken;
}

void OutputPipe::close() {
  const std::scoped_lock lock(mutex_);
  is_closed_ = true;
  pieces_.clear();
  size_ = 0;
  room_.notify_all();
}

bool OutputPipe::isEmpty() {
  const std::scoped_lock lock(mutex_);
  return pieces_.empty();
}

PipeStream::Buffer::int_type PipeStream::Buffer::overflow(int_type letter) {
  if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
  const char text = traits_type::to_char_type(letter);
  return pipe_.write(kind_, {&text, 1}) ? letter : traits_type::eof();
}

std::streamsize PipeStream::Buffer::xsputn(const char* text, std::streamsize size) {
  return pipe_.write(kind_, {text, static_cast<std::size_t>(size)}) ? size : 0;
}

}  // namespace tendon::gui
