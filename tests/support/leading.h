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

/// The actions of the components; outlives them.
using Story = tendon::test::Record<std::string>;

/// Leads the next component, and may have a leader itself. Reports each stop that reaches it, and
/// its Cleanup(), in which it sends a stop to the next one.
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

  std::atomic<std::chrono::milliseconds> work{std::chrono::milliseconds(0)};  ///< of one cycle
  std::atomic<bool> floods = false;   ///< sends until it is refused
  std::atomic<bool> executes = true;  ///< executes received commands
  std::atomic<bool> holds = false;    ///< holds a cycle until it is false again
  std::atomic<bool> is_held = false;
  std::atomic<std::uint64_t> refused = 0;  ///< commands refused for lack of room
  std::atomic<std::uint64_t> gone = 0;     ///< lost clients that were reported to it

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
    // Reserves the place first: the next component may stop, and report it, before stop_() returns.
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
