#pragma once

#include <benchmarks/case.h>
#include <benchmarks/measurement.h>
#include <benchmarks/remote/raw_ice.h>
#include <benchmarks/remote/rivals/rival.h>
#include <benchmarks/remote/robot.h>
#include <support/folder.h>
#include <support/program.h>
#include <tendon/middleware/hello.h>
#include <tendon/process/process.h>

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>

namespace tendon::benchmark {

/// The time limit for answers on a machine that stalls.
inline constexpr std::chrono::seconds kTestTimeout(30);

/// A robot in another process, a desk in this process that is connected to the robot, and raw Ice
/// between these two processes. All threads run on the processor of the thread that created this
/// object. On several processors, the time to wake another processor would hide everything else.
class RemoteSystem {
 public:
  RemoteSystem();

  struct Addresses {
    std::string gcm;
    std::string robot;
    std::string raw;
    std::string raw_of_one_thread;
  };
  [[nodiscard]] const Addresses& addresses() const { return addresses_; }

  [[nodiscard]] Desk& desk() { return *desk_; }
  [[nodiscard]] RawIce& raw() { return *raw_; }
  /// The client for the server in which one thread dispatches all calls.
  [[nodiscard]] RawIce& raw_of_one_thread() { return *raw_of_one_thread_; }

  /// Another middleware, which is started at both ends when it is first used.
  [[nodiscard]] RivalClient& rival(const std::string& id);

  /// The options for the next process in this program.
  [[nodiscard]] ProcessOptions Options() const;
  /// The environment for programs that take part in the system.
  [[nodiscard]] std::map<std::string, std::string> environment() const;
  /// Returns a name that no process has used before.
  [[nodiscard]] std::string NewName();

  /// The pid of the other process.
  [[nodiscard]] int peer() const { return peer_->pid(); }
  /// The processor time in seconds that the other process has used.
  [[nodiscard]] double ProcessorTime() const;

 private:
  bool IsConnected();
  void BeginRivals();

  const test::Folder folder_;  // the state and run-time folder of the programs
  std::unique_ptr<Program> peer_;
  Addresses addresses_;
  std::unique_ptr<Process> process_;
  Desk* desk_ = nullptr;
  std::unique_ptr<RawIce> raw_;
  std::unique_ptr<RawIce> raw_of_one_thread_;
  // The other middlewares by id; empty until they are started.
  std::map<std::string, std::unique_ptr<RivalClient>> rivals_;
  int names_ = 0;
};

/// The identity with which a program of this name connects to the other process.
Hello NewHello(const std::string& name);

/// The system that all cases share; created by the first call.
using TheSystem = std::function<RemoteSystem&()>;

/// Makes a subject that keeps both processes busy.
Subject Between(const TheSystem& system, std::function<double(RemoteSystem&)> run);

/// Returns the time of one read from the robot.
double ReadJoints(RemoteSystem& system, std::uint64_t reads);

/// Throws if `done` is false, because then there is nothing to measure.
void Require(bool done, const char* what);

// The cases, by subject.
std::vector<Case> RemoteCases(const Effort& effort, const TheSystem& system);
std::vector<Case> RivalCases(const Effort& effort, const TheSystem& system);
std::vector<Case> StreamCases(const Effort& effort, const TheSystem& system);
std::vector<Case> JoiningCases(const Effort& effort, const TheSystem& system);
std::vector<Case> CatalogueCases(const Effort& effort, const TheSystem& system);
std::vector<Case> QueryCases(const Effort& effort, const TheSystem& system);
std::vector<Case> RecordingLoadCases(const Effort& effort, const TheSystem& system);

}  // namespace tendon::benchmark
