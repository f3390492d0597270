#pragma once

#include <tendon/interface/connection.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/interface/arm_fixture.h"
#include "support/wait.h"

namespace tendon_test {

using namespace std::chrono_literals;

/// A server with commands for which the callers wait. The test or another thread executes its
/// inbox.
struct Planner {
  tendon::Inbox inbox;
  tendon::ProvidedInterface plans{"Plans", &inbox};

  std::atomic<bool> gate_is_open = true;  ///< Slow() waits until this is true
  std::atomic<int> slow_begun = 0;
  std::vector<std::int32_t> moves;

  Planner() {
    plans.AddCommandVoidReturn(&Planner::Count, this, "Count");
    plans.AddCommandWriteReturn(&Planner::Describe, this, "Describe");
    plans.AddCommandWrite(&Planner::Move, this, "Move");
    plans.AddCommandVoid(&Planner::Slow, this, "Slow");
    plans.AddCommandVoid(&Planner::Break, this, "Break");
    inbox.SetAccepting(true);
  }

  void Count(std::int32_t& count) { count = static_cast<std::int32_t>(moves.size()); }
  void Describe(const std::string& prefix, Message& message) {
    message.text = prefix + std::to_string(moves.size());
    message.numbers.assign(moves.begin(), moves.end());
  }
  void Move(std::int32_t goal) { moves.push_back(goal); }
  void Slow() {
    ++slow_begun;
    while (!gate_is_open) std::this_thread::yield();
  }
  void Break() { throw std::runtime_error("broken"); }
};

/// A client with one function for each command. Because it has an inbox, only one thread may call.
struct Operator {
  tendon::Inbox inbox;
  tendon::RequiredInterface planner{"Planner", &inbox};
  tendon::VoidReturnFunction<std::int32_t> count;
  tendon::WriteReturnFunction<std::string, Message> describe;
  tendon::WriteFunction<std::int32_t> move;
  tendon::VoidFunction slow;
  tendon::VoidFunction fail;

  Operator() {
    planner.AddFunction(count, "Count");
    planner.AddFunction(describe, "Describe");
    planner.AddFunction(move, "Move");
    planner.AddFunction(slow, "Slow");
    planner.AddFunction(fail, "Break");
  }
};

inline auto Connect(Operator& client, Planner& server) {
  return tendon::Connection::Make(client.planner, server.plans, "operator/Planner",
                                  "planner/Plans");
}

/// Executes an inbox in its own thread, like a task. Continues after an exception.
class Executor {
 public:
  explicit Executor(tendon::Inbox& inbox)
      : thread_([&inbox](const std::stop_token& stop) {
          inbox.BindToThisThread();
          while (!stop.stop_requested()) {
            try {
              if (inbox.ExecuteQueued() == 0) std::this_thread::yield();
            } catch (const std::exception&) {
              continue;
            }
          }
          inbox.Unbind();
        }) {}

 private:
  std::jthread thread_;
};

}  // namespace tendon_test
