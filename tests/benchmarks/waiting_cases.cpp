#include <benchmarks/floors.h>
#include <benchmarks/measurement.h>
#include <tendon/base/os/futex.h>
#include <tendon/manager/local_manager.h>
#include <tendon/task/signal_task.h>

#include <atomic>
#include <memory>
#include <thread>

namespace tendon::benchmark {
namespace {

/// Sleeps until it is asked.
class Server final : public SignalTask {
 public:
  explicit Server(std::string name) : SignalTask(std::move(name)) {
    AddProvidedInterface("Control").AddCommandWriteReturn(&Server::Echo, this, "Echo");
  }
  ~Server() override { Join(); }

 private:
  void Run() override { ProcessQueuedCommands(); }
  void Echo(const Message& question, Message& answer) { answer = question; }
};

class Client final : public Component {
 public:
  explicit Client(std::string name) : Component(std::move(name)) {
    AddRequiredInterface("Server").AddFunction(echo, "Echo");
  }

  WriteReturnFunction<Message, Message> echo;
};

double CallAndWait(std::uint64_t calls) {
  LocalManager manager;
  manager.Add<Server>("server");
  auto& client = manager.Add<Client>("client");
  (void)manager.Connect({"client", "Server"}, {"server", "Control"});
  (void)manager.StartAll();
  Message question{};
  Message answer{};
  return NanosecondsEach(calls, [&](std::uint64_t i) {
    question[0] = static_cast<double>(i);
    while (!client.echo.Wait(question, answer, std::chrono::seconds(1))) {  // a stalled machine
    }
    Use(answer);
  });
}

/// Two threads that wake each other in turns.
double WakeInTurns(std::uint64_t rounds) {
  constexpr std::chrono::seconds kTimeout(1);
  const auto last = static_cast<std::uint32_t>(2 * rounds);
  std::atomic<std::uint32_t> turn = 0;
  const auto await = [&](std::uint32_t mine) {
    for (std::uint32_t now = turn; now < mine; now = turn) os::FutexWait(turn, now, kTimeout);
  };
  const auto pass_on = [&](std::uint32_t next) {
    turn = next;
    os::FutexWake(turn);
  };
  std::jthread other([&] {
    for (std::uint32_t mine = 1; mine < last; mine += 2) {
      await(mine);
      pass_on(mine + 1);
    }
  });
  return NanosecondsEach(rounds, [&](std::uint64_t i) {
    const auto mine = static_cast<std::uint32_t>(2 * i);
    pass_on(mine + 1);
    await(mine + 2);
  });
}

}  // namespace

std::vector<Case> WaitingCases(const Effort& effort) {
  const std::uint64_t rounds = effort.Times(5'000);
  return {{.id = "D5",
           .what = "waiting for a command's result / futex round trip",
           .gate = 1.3,
           .stretch = 1.1,
           .repetition = SideBySide({[=] { return CallAndWait(rounds); }, kSleeps},
                                    {[=] { return WakeInTurns(rounds); }, kSleeps})}};
}

}  // namespace tendon::benchmark
