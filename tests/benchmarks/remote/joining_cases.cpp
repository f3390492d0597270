#include <benchmarks/remote/remote_system.h>
#include <support/wait.h>
#include <tendon/middleware/channel.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>

namespace tendon::benchmark {
namespace {

double Since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

/// Measures the time from nothing until the process is a member of the system.
double Join(RemoteSystem& system) {
  const std::string name = system.NewName();
  const auto start = std::chrono::steady_clock::now();
  const Process process(name, system.Options());
  Require(process.WaitUntilJoined(kTestTimeout).ok(), "a process does not join");
  return Since(start);
}

/// Measures the time of the first connection of a process to the other process.
double Connect(RemoteSystem& system) {
  const std::string name = system.NewName();
  Process process(name, system.Options());
  process.Add<Desk>("desk");
  Require(process.WaitUntilJoined(kTestTimeout).ok(), "a process does not join");
  const auto start = std::chrono::steady_clock::now();
  const auto made = process.Connect({name, "desk", "Robot"}, {"robot", "robot", "Control"});
  const double took = Since(start);
  Require(made.ok() && process.connections().front().state == ConnectionState::kActive,
          "a process does not connect");
  return took;
}

std::size_t ThreadsOf(int pid) {
  const std::filesystem::directory_iterator threads("/proc/" + std::to_string(pid) + "/task");
  return static_cast<std::size_t>(std::distance(threads, {}));
}

/// The program lcm without a component; it has joined the GCM.
class IdleLcm {
 public:
  explicit IdleLcm(RemoteSystem& system)
      : program_({TENDON_LCM, "--name", system.NewName(), "--gcm", system.addresses().gcm},
                 system.environment()) {
    Require(EventuallyTrue([this] { return program_.err().find("joined") != std::string::npos; }),
            "the lcm does not join");
  }
  [[nodiscard]] std::size_t threads() const { return ThreadsOf(program_.pid()); }

 private:
  Program program_;
};

double CountThreads(RemoteSystem& system) { return static_cast<double>(IdleLcm(system).threads()); }

/// Returns how many threads the robot's process adds for each process that connects. Connects more
/// processes than the two thread pools of Ice can add threads, so that their growth does not count.
double CountThreadsOfAConnection(RemoteSystem& system) {
  constexpr std::size_t kMore = 12;
  const std::size_t before = ThreadsOf(system.peer());
  std::vector<std::unique_ptr<Process>> processes;
  for (std::size_t i = 0; i < kMore; ++i) {
    const std::string name = system.NewName();
    processes.push_back(std::make_unique<Process>(name, system.Options()));
    processes.back()->Add<Desk>("desk");
    Require(
        processes.back()->WaitUntilJoined(kTestTimeout).ok() &&
            processes.back()->Connect({name, "desk", "Robot"}, {"robot", "robot", "Control"}).ok(),
        "a process does not connect");
  }
  const std::size_t after = ThreadsOf(system.peer());
  return static_cast<double>(after - std::min(before, after)) / kMore;
}

}  // namespace

std::vector<Case> JoiningCases(const Effort& /*effort*/, const TheSystem& system) {
  const auto sleeping = [&](auto function) {
    Subject subject = Between(system, function);
    subject.processors = kSleeps;
    return subject;
  };
  const auto first_ping = sleeping([](RemoteSystem& both) { return both.raw().Connect(); });
  const auto counted = [&](double (*count)(RemoteSystem&)) {
    return [system, count] { return std::optional(Pair{.ours = count(system())}); };
  };
  return {
      {.id = "R9",
       .what = "join a system / Ice new connection and first ping",
       .gate = 50,
       .stretch = 10,
       .repetition = SideBySide(sleeping(Join), first_ping)},
      {.id = "R9-con",
       .what = "remote connect / the same",
       .gate = 10,
       .stretch = 5,
       .repetition = SideBySide(sleeping(Connect), first_ping)},
      {.id = "T1",
       .what = "threads of an idle lcm",
       .unit = "1",
       .gate = 12,
       .repetition = counted(CountThreads),
       .runs_once = true},
      {.id = "T1-con",
       .what = "threads for each further connection",
       .unit = "1",
       .gate = 0,
       .repetition = counted(CountThreadsOfAConnection)},
  };
}

}  // namespace tendon::benchmark
