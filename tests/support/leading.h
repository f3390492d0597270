#pragma once

#include <tendon/base/status.h>
#include <tendon/task/periodic_task.h>

#include <atomic>
#include <chrono>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <thread>
#include <utility>

#include "support/record.h"

/// Components in a chain: each leads the next one and stops it in its own Cleanup().
namespace leading {

/// Records the actions of the components; must outlive the components.
using Story = tendon::test::Record<std::string>;

/// A component that leads the next one, and may have a leader itself. It records each stop command
/// that it receives, and its own Cleanup(). In Cleanup(), it sends a stop command to the next
/// component.
template <std::derived_from<tendon::Task> Base>
class Leading final : public Base {
 public:
  Leading(std::string name, Story& story)
      : Base(std::move(name), std::chrono::milliseconds(1)), story_(story) {
    auto& control = this->AddProvidedInterface("Control");
    control.AddCommandVoid(&Leading::Go, this, "Go");
    control.AddCommandVoid(&Leading::Stop, this, "Stop");
    auto& next = this->AddRequiredInterface("Next", tendon::Need::kOptional);
    next.SetMailboxCapacity(4);
    next.AddFunction(go_, "Go");
    next.AddFunction(stop_, "Stop");
  }

  /// Working time of one cycle.
  std::atomic<std::chrono::milliseconds> work{std::chrono::milliseconds(0)};
  std::atomic<bool> floods = false;   ///< true: sends commands until one is refused
  std::atomic<bool> executes = true;  ///< true: executes received commands
  std::atomic<bool> holds = false;    ///< true: a cycle blocks until this is false again
  std::atomic<bool> is_held = false;
  std::atomic<std::uint64_t> refused = 0;  ///< commands refused because a mailbox was full
  std::atomic<std::uint64_t> gone = 0;     ///< lost clients that were reported to this component

 private:
  void Run() override {
    if (executes) this->ProcessQueuedCommands();
    tendon::Status sent = tendon::Status::kQueued;
    while (floods && sent) sent = go_();
    if (sent == tendon::Status::kQueueFull) ++refused;
    std::this_thread::sleep_for(work.load());
    while (holds) {
      is_held = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  void Cleanup() override {
    // Reserves the place in the record first: before stop_() returns, the next component may stop
    // and record this.
    const std::size_t place = story_.Add("");
    const tendon::Status sent = stop_();
    const std::string outcome = sent ? "" : ", " + std::string(ToString(sent));
    story_.Replace(place, this->name() + " ends" + outcome);
  }
  void Go() { ++gone; }
  void Stop() { story_.Add(this->name() + " is stopped"); }

  Story& story_;
  tendon::VoidFunction go_;
  tendon::VoidFunction stop_;
};

}  // namespace leading
