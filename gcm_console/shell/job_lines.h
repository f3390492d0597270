#pragma once

#include <cstddef>
#include <deque>
#include <mutex>
#include <streambuf>
#include <string>

namespace console {

/// Collects the lines of several threads until they are printed. Counts the lines that do not fit.
/// Thread-safe.
class JobLines {
 public:
  static constexpr std::size_t kMost = 1000;

  /// `line` has no line end.
  void Add(std::string line);
  /// Takes all lines since the last call, each with its line end.
  std::string Take();

 private:
  std::mutex mutex_;
  std::deque<std::string> lines_;
  std::size_t left_out_ = 0;
};

/// Splits the output of one thread into lines.
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
