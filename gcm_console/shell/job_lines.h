#pragma once

#include <cstddef>
#include <deque>
#include <mutex>
#include <streambuf>
#include <string>

namespace console {

/// Lines of several threads, until they are printed. Those for which there is no room are counted.
/// Thread-safe.
class JobLines {
 public:
  static constexpr std::size_t kMost = 1000;

  /// Without its end.
  void Add(std::string line);
  /// All since the last time, each with its end.
  std::string Take();

 private:
  std::mutex mutex_;
  std::deque<std::string> lines_;
  std::size_t left_out_ = 0;
};

/// What one thread writes becomes lines.
class JobStream final : public std::streambuf {
 public:
  explicit JobStream(JobLines& lines) : lines_(lines) {}

 protected:
  int_type overflow(int_type letter) override;
  std::streamsize xsputn(const char* text, std::streamsize count) override;

 private:
  void Put(char letter);

  JobLines& lines_;
  std::string line_;
};

}  // namespace console
