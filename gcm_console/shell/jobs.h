#pragma once

#include <gcm_console/command_line/settings.h>
#include <gcm_console/shell/command_parser.h>
#include <tendon/base/result.h>

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <ostream>
#include <streambuf>
#include <string>
#include <vector>

namespace console {

/// Collects the lines of several threads until they are printed. If the buffer is full, further
/// lines are only counted. Thread-safe.
class JobLines {
 public:
  static constexpr std::size_t kMax = 1000;

  /// Adds a line. `line` does not contain the line end.
  void Add(std::string line);
  /// Returns all lines since the last call, each with its line end.
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

/// Commands in the background. Each runs in its own thread and over its own link, until it ends by
/// itself or this object is destroyed. For one thread.
class Jobs {
 public:
  Jobs();
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;
  /// Ends all jobs.
  ~Jobs();

  /// Starts a job and prints its number. Returns kInvalid if the verb cannot run in the background.
  /// `columns` is the width of the terminal.
  tendon::Result<void> Begin(const Words& words, const Settings& settings, int columns);
  /// Ends the job with this number, and waits for its end. Returns kNotFound if there is no such
  /// job.
  tendon::Result<void> End(const std::string& number);
  void EndAll();
  /// Prints the number and the words of each running job.
  void Print(std::ostream& out);

  /// Returns the complete lines that the jobs have written since the last call. Returns no value if
  /// no job is running and all lines were taken.
  std::optional<std::string> TakeLines();

 private:
  class Job;
  void ForgetEnded();

  JobLines lines_;
  std::vector<std::unique_ptr<Job>> jobs_;
  int last_number_ = 0;
};

}  // namespace console
