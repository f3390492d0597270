#include <gcm_console/shell/job_lines.h>
#include <tendon/base/text.h>

#include <utility>

namespace console {

void JobLines::Add(std::string line) {
  const std::scoped_lock lock(mutex_);
  if (lines_.size() < kMost) {
    lines_.push_back(std::move(line));
  } else {
    ++left_out_;
  }
}

std::string JobLines::Take() {
  const std::scoped_lock lock(mutex_);
  std::string all;
  for (const std::string& line : lines_) all += line + '\n';
  if (left_out_ > 0) {
    all += "gcm: " + tendon::Counted(left_out_, "line is left out", "lines are left out") +
           ": there was no room for more\n";
  }
  lines_.clear();
  left_out_ = 0;
  return all;
}

JobStream::int_type JobStream::overflow(int_type letter) {
  if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
  Put(traits_type::to_char_type(letter));
  return letter;
}

std::streamsize JobStream::xsputn(const char* text, std::streamsize count) {
  for (std::streamsize i = 0; i < count; ++i) Put(text[i]);
  return count;
}

void JobStream::Put(char letter) {
  if (letter == '\n') {
    lines_.Add(std::exchange(line_, ""));
  } else {
    line_ += letter;
  }
}

}  // namespace console
