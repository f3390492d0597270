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

/// With whoever answers late on a machine that stalls.
inline constexpr std::chrono::seconds kPatience(30);

/// A robot in a process of its own, and a desk here that is connected to it; and raw Ice between
/// the same two processes. All threads run on the processor of the thread that created it. On
/// several processors, the time to wake another processor would hide everything else.
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
  /// For a server in which one thread dispatches instead of a pool.
  [[nodiscard]] RawIce& raw_of_one_thread() { return *raw_of_one_thread_; }

  /// Another middleware, which is started at both ends when it is first used.
  [[nodiscard]] RivalClient& rival(const std::string& id);

  /// How the next process here takes part.
  [[nodiscard]] ProcessOptions Options() const;
  /// What programs must know that take part.
  [[nodiscard]] std::map<std::string, std::string> environment() const;
  /// A name that no process had before.
  [[nodiscard]] std::string NewName();

  /// The other process.
  [[nodiscard]] int peer() const { return peer_->pid(); }
  /// The seconds of processor time that it has used.
  [[nodiscard]] double ProcessorTime() const;

 private:
  bool IsConnected();
  void BeginRivals();

  const test::Folder folder_;  // what programs keep for their user
  std::unique_ptr<Program> peer_;
  Addresses addresses_;
  std::unique_ptr<Process> process_;
  Desk* desk_ = nullptr;
  std::unique_ptr<RawIce> raw_;
  std::unique_ptr<RawIce> raw_of_one_thread_;
  std::map<std::string, std::unique_ptr<RivalClient>> rivals_;  // by id, once they are begun
  int names_ = 0;
};

/// The identity with which a program of this name connects to the other process.
Hello NewHello(const std::string& name);

/// The system that all cases share; created by the first call.
using TheSystem = std::function<RemoteSystem&()>;

/// What keeps both processes busy.
Subject Between(const TheSystem& system, std::function<double(RemoteSystem&)> run);

/// What one read of the robot takes.
double ReadJoints(RemoteSystem& system, std::uint64_t reads);

/// Throws if `done` is false, because then there is nothing to measure.
void Require(bool done, const char* what);

// The cases, by what they are about.
std::vector<Case> RemoteCases(const Effort& effort, const TheSystem& system);
std::vector<Case> RivalCases(const Effort& effort, const TheSystem& system);
std::vector<Case> StreamCases(const Effort& effort, const TheSystem& system);
std::vector<Case> JoiningCases(const Effort& effort, const TheSystem& system);
std::vector<Case> CatalogueCases(const Effort& effort, const TheSystem& system);
std::vector<Case> QueryCases(const Effort& effort, const TheSystem& system);
std::vector<Case> RecordingLoadCases(const Effort& effort, const TheSystem& system);

}  // namespace tendon::benchmark
