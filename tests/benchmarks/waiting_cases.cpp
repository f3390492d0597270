#include <benchmarks/floors.h>
#include <benchmarks/measurement.h>
#include <tendon/manager/local_manager.h>
#include <tendon/task/signal_task.h>

#include <memory>

namespace tendon::benchmark {
namespace {

/// Sleeps until a command arrives.
class Server final : public SignalTask {
 public:
  explicit Server(std::string name) : SignalTask(std::move(name)) {
    AddProvidedInterface("Control").AddCommandWriteReturn(&Server::Echo, this, "Echo");
  }
  ~Server() override { Join(); }

 private:
  void Run() override { ProcessQueuedCommands(); }
  void Echo(const Message& question, Message& reply) { reply = question; }
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
  Message reply{};
  return NanosecondsEach(calls, [&](std::uint64_t i) {
    question[0] = static_cast<double>(i);
    // Tries again on a machine that stalls.
    while (!client.echo.Wait(question, reply, std::chrono::seconds(1))) {
    }
    Use(reply);
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
