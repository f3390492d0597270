#include <components/recorder/recorder_component.h>

#include <tendon/base/log.h>
#include <tendon/base/text.h>
#include <tendon/process/process.h>
#include <tendon/recording/condition.h>

#include <chrono>
#include <string>
#include <utility>

namespace recorder {
namespace {

constexpr std::chrono::milliseconds kPeriod{100};

/// Throws ConfigurationError if the condition cannot be parsed, or if it is empty but `time` needs
/// it.
void RequireCondition(const std::string& field, const std::string& condition,
                      const std::string& time_field, double time) {
  if (condition.empty()) {
    if (time == 0.0) return;
    throw tendon::ConfigurationError("'" + time_field + "' needs '" + field + "'");
  }
  const auto parsed = tendon::recording::ParseCondition(condition);
  if (parsed) return;
  throw tendon::ConfigurationError("'" + field + "': " + parsed.error().message);
}

}  // namespace

RecorderComponent::RecorderComponent(std::string name, Configuration configuration)
    : PeriodicTask(std::move(name), kPeriod), configuration_(std::move(configuration)) {
  if (configuration_.patterns.empty()) {
    throw tendon::ConfigurationError(
        "'patterns' is empty, so nothing would be recorded; expected paths such as \"**\"");
  }
  if (configuration_.name.find('/') != std::string::npos ||
      configuration_.name.find("..") != std::string::npos) {
    throw tendon::ConfigurationError("'name' is " + tendon::Quoted(configuration_.name, 100) +
                                     "; expected the beginning of a file name, without / and ..; "
                                     "the files are written into 'folder'");
  }
  if (configuration_.keep > 0 && configuration_.split_size == 0 &&
      configuration_.split_time == 0.0) {
    throw tendon::ConfigurationError("'keep' needs 'split_size' or 'split_time'");
  }
  RequireCondition("start_when", configuration_.start_when, "before", configuration_.before);
  RequireCondition("stop_when", configuration_.stop_when, "after", configuration_.after);
  state_table().Add(state_, "State");
  auto& control = AddProvidedInterface("Control");
  control.AddCommandVoid(&RecorderComponent::StartRecording, this, "Start");
  control.AddCommandVoid(&RecorderComponent::StopRecording, this, "Stop");
  control.AddCommandWrite(&RecorderComponent::SaveLast, this, "SaveLast");
  control.AddEvent(started_, "Started");
  control.AddEvent(stopped_, "Stopped");
  control.AddEvent(saved_, "Saved");
  control.AddEvent(failed_, "Failed");
}

void RecorderComponent::OnAdding(tendon::LocalManager& manager) {
  auto* const process = dynamic_cast<tendon::Process*>(&manager);
  if (process == nullptr) {
    throw tendon::ConfigurationError(
        "component '" + name() +
        "' can record only in a tendon::Process, but its manager is not a tendon::Process");
  }
  process_ = process->OpenLocalAccess();
}

void RecorderComponent::Startup() {
  thread_ = std::make_unique<RecordingThread>(process_, configuration_);
  if (configuration_.record_at_start) thread_->Start();
}

void RecorderComponent::Run() {
  ProcessQueuedCommands();
  state_ = thread_->state();
  RaiseEvents();
}

void RecorderComponent::Cleanup() {
  thread_->Finish();
  state_ = thread_->state();
  RaiseEvents();
  thread_.reset();
}

void RecorderComponent::RaiseEvents() {
  for (const RecordingOutcome& outcome : thread_->TakeOutcomes()) {
    switch (outcome.kind) {
      case RecordingOutcome::Kind::kStarted:
        started_(outcome.text);
        break;
      case RecordingOutcome::Kind::kStopped:
        stopped_(outcome.text);
        break;
      case RecordingOutcome::Kind::kSaved:
        saved_(outcome.text);
        break;
      case RecordingOutcome::Kind::kDelayed:
        tendon::Log(tendon::LogLevel::kWarning, name(), outcome.text);
        break;
      case RecordingOutcome::Kind::kFailed:
        tendon::Log(tendon::LogLevel::kError, name(), outcome.text);
        failed_(outcome.text);
        break;
    }
  }
}

}  // namespace recorder
