#include <gcm_console/shell/jobs.h>

#include <gcm_console/command_line/shell_session.h>
#include <gcm_console/console.h>
#include <gcm_console/output/table.h>
#include <tendon/base/os/termination.h>
#include <tendon/base/text.h>

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

/// The verbs that run until the user ends them.
constexpr std::array<std::string_view, 4> kLasting = {"watch", "events", "hz", "log"};

std::string TextOf(const Words& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + QuoteWord(word);
  return text;
}

}  // namespace

void JobLines::Add(std::string line) {
  const std::scoped_lock lock(mutex_);
  if (lines_.size() < kMax) {
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
    all += "gcm: " + tendon::Counted(left_out_, "line is omitted", "lines are omitted") +
           ": the buffer for their output is full\n";
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
    RequestEnd();
    thread_.join();
  }

  [[nodiscard]] const std::string& number() const { return number_; }
  /// Returns number and words: "1  watch robot/arm/state.Joints".
  [[nodiscard]] std::string text() const { return number_ + "  " + Plain(text_); }
  [[nodiscard]] bool has_ended() {
    const std::scoped_lock lock(mutex_);
    return has_ended_;
  }
  void RequestEnd() {
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
  /// Sets the object that interrupts the job. Returns false if the end of the job was already
  /// requested.
  bool Listen(tendon::os::Interruption* interruption) {
    const std::scoped_lock lock(mutex_);
    interruption_ = interruption;
    return !is_unwanted_;
  }

  const std::string number_;
  const std::string text_;
  ShellSession session_;
  std::mutex mutex_;
  tendon::os::Interruption* interruption_ = nullptr;
  bool is_unwanted_ = false;
  bool has_ended_ = false;
  std::thread thread_;  // the last member, because it uses the other members
};

Jobs::Jobs() = default;
Jobs::~Jobs() { EndAll(); }

Result<void> Jobs::Begin(const Words& words, const Settings& settings, int columns) {
  if (std::ranges::find(kLasting, words[0]) == kLasting.end()) {
    return Error{ErrorCode::kInvalid,
                 "only watch, events, hz and log can run in the background, but '" + words[0] +
                     "' cannot: repeat the command without &"};
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
    return Error{ErrorCode::kNotFound, "no background job has the number '" + number +
                                           "'; to list the background jobs: jobs"};
  }
  jobs_.erase(job);
  return {};
}

void Jobs::EndAll() {
  for (const auto& job : jobs_) job->RequestEnd();
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
