#pragma once

#include <gcm_console/line/settings.h>
#include <gcm_console/shell/job_lines.h>
#include <gcm_console/shell/words.h>
#include <tendon/base/result.h>

#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace console {

/// Commands that go on behind the prompt, each in a thread of its own and over its own link, until
/// they end by themselves, or with this. Used by one thread.
class Jobs {
 public:
  Jobs();
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;
  /// Ends all.
  ~Jobs();

  /// Begins one, and says by which number it is called. kInvalid where the verb goes on for no
  /// longer than it is waited for. `columns` is the width of the terminal.
  tendon::Result<void> Begin(const Words& words, const Settings& settings, int columns);
  /// Ends the one of that number, and waits for it; kNotFound where there is none.
  tendon::Result<void> End(const std::string& number);
  void EndAll();
  /// A line for each that goes on: number and words.
  void Print(std::ostream& out);

  /// What they have said since the last time, in whole lines; nothing where none goes on, and all
  /// was said.
  std::optional<std::string> TakeLines();

 private:
  class Job;
  void ForgetEnded();

  JobLines lines_;
  std::vector<std::unique_ptr<Job>> jobs_;
  int last_number_ = 0;
};

}  // namespace console
