#include <gcm_console/console.h>
#include <gcm_console/line/session.h>
#include <gcm_console/report.h>
#include <gcm_console/shell/jobs.h>
#include <tendon/base/os/termination.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <string_view>
#include <thread>
#include <utility>

namespace console {
namespace {

using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;

/// Verbs that run until the user ends them.
constexpr std::array<std::string_view, 4> kLasting = {"watch", "events", "hz", "log"};

std::string TextOf(const Words& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + Quoted(word);
  return text;
}

}  // namespace

class Jobs::Job {
 public:
  Job(int number, const Words& words, const Settings& settings, int columns, JobLines& lines)
      : number_(std::to_string(number)),
        text_(TextOf(words)),
        session_(settings),
        thread_([this, words, columns, &lines] { Run(words, columns, lines); }) {}
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;
  ~Job() {
    AskForTheEnd();
    thread_.join();
  }

  [[nodiscard]] const std::string& number() const { return number_; }
  /// "1  watch robot/arm/state.Joints".
  [[nodiscard]] std::string text() const { return number_ + "  " + Plain(text_); }
  [[nodiscard]] bool has_ended() {
    const std::scoped_lock lock(mutex_);
    return has_ended_;
  }
  void AskForTheEnd() {
    const std::scoped_lock lock(mutex_);
    is_unwanted_ = true;
    if (interruption_ != nullptr) interruption_->Request();
  }

 private:
  void Run(const Words& words, int columns, JobLines& lines) {
    tendon::os::Interruption interruption;
    if (Listen(&interruption)) {
      JobStream buffer(lines);
      std::ostream out(&buffer);
      RunCommandLine(words, {.out = out, .err = out, .columns = columns, .has_input = false},
                     session_);
    }
    Listen(nullptr);
    lines.Add("gcm: ended: " + text());
    const std::scoped_lock lock(mutex_);
    has_ended_ = true;
  }
  /// Returns false if the end was already requested.
  bool Listen(tendon::os::Interruption* interruption) {
    const std::scoped_lock lock(mutex_);
    interruption_ = interruption;
    return !is_unwanted_;
  }

  const std::string number_;
  const std::string text_;
  Session session_;
  std::mutex mutex_;
  tendon::os::Interruption* interruption_ = nullptr;
  bool is_unwanted_ = false;
  bool has_ended_ = false;
  std::thread thread_;  // the last member: it uses the others
};

Jobs::Jobs() = default;
Jobs::~Jobs() { EndAll(); }

Result<void> Jobs::Begin(const Words& words, const Settings& settings, int columns) {
  if (std::ranges::find(kLasting, words[0]) == kLasting.end()) {
    return Error{ErrorCode::kInvalid,
                 "only watch, events, hz and log can run in the background, but '" + words[0] +
                     "' cannot; leave out the &"};
  }
  ForgetEnded();
  jobs_.push_back(std::make_unique<Job>(++last_number_, words, settings, columns, lines_));
  lines_.Add("gcm: in the background: " + jobs_.back()->text());
  return {};
}

Result<void> Jobs::End(const std::string& number) {
  ForgetEnded();
  const auto job = std::ranges::find(jobs_, number, [](const auto& one) { return one->number(); });
  if (job == jobs_.end()) {
    return Error{ErrorCode::kNotFound,
                 "no background job has the number '" + number + "'; jobs lists them"};
  }
  jobs_.erase(job);
  return {};
}

void Jobs::EndAll() {
  for (const auto& job : jobs_) job->AskForTheEnd();
  jobs_.clear();
}

void Jobs::Print(std::ostream& out) {
  ForgetEnded();
  for (const auto& job : jobs_) out << job->text() << '\n';
}

std::optional<std::string> Jobs::TakeLines() {
  ForgetEnded();
  std::string lines = lines_.Take();
  if (lines.empty() && jobs_.empty()) return std::nullopt;
  return lines;
}

void Jobs::ForgetEnded() {
  std::erase_if(jobs_, [](const auto& job) { return job->has_ended(); });
}

}  // namespace console
