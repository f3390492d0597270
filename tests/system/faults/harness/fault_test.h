#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/gcm/client.h>
#include <tendon/middleware/middleware.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "support/folder.h"
#include "support/machine/stall_meter.h"
#include "support/program.h"
#include "system/faults/harness/command_checker.h"
#include "system/faults/harness/process_watch.h"
#include "system/faults/harness/size.h"
#include "system/faults/harness/stream_checker.h"

namespace faults {

/// A GCM and LCMs as real processes, with the middleware of the parameter, and a viewer in this
/// process. `robot` has a ledger. `desk` has a client that sends commands to the ledger, on its own
/// connection.
class FaultTest : public testing::TestWithParam<std::string> {
 protected:
  FaultTest();
  ~FaultTest() override;

  using Words = Program::Words;
  using Environment = std::map<std::string, std::string>;

  /// Starts the GCM, always at the same address. Returns when it serves.
  void StartGcm();
  /// Starts a GCM without waiting; the GCM may fail to start.
  [[nodiscard]] std::unique_ptr<Program> MakeGcm() const;
  /// Starts an LCM without waiting; `more` are further options.
  [[nodiscard]] std::unique_ptr<Program> MakeLcm(const std::string& name,
                                                 const Words& more = {}) const;
  /// Starts the GCM, robot, desk, and a viewer that reads the ledger's stream. Returns when all of
  /// them work.
  void StartSystem();
  void StartViewer();
  /// Runs `gcm WORDS...` to its end.
  [[nodiscard]] Outcome Gcm(Words words) const;
  /// Returns a new middleware with the user's cookie, for peers in this process.
  [[nodiscard]] virtual std::shared_ptr<tendon::Middleware> NewMiddleware() const;
  /// Returns the command line that starts a program of Tendon.
  [[nodiscard]] Words Command(const std::string& program, const Words& words) const;
  [[nodiscard]] Environment environment() const;

  [[nodiscard]] bool EventuallyIs(const std::string& process, tendon::ProcessState state) const;
  /// Waits until the component is active. A process joins before its components start, and refuses
  /// commands until then. So it is not enough to wait for the process.
  [[nodiscard]] bool EventuallyActive(const std::string& process,
                                      const std::string& component) const;
  [[nodiscard]] std::string AddressOf(const std::string& process) const;
  /// Waits until the connection from the desk's client to the robot's ledger is active.
  [[nodiscard]] bool EventuallyConnected() const;
  /// Waits until `rows` more rows have arrived and some more commands were executed.
  [[nodiscard]] bool Flows(std::uint64_t rows = 100) const;
  /// Waits until some more commands of at least `clients` clients were executed.
  [[nodiscard]] bool EventuallyExecutesMore(std::size_t clients = 1) const;
  /// Returns the number of lines that contain `words`, in all journals of one kind.
  [[nodiscard]] std::size_t Lines(const std::string& kind, const std::string& words = {}) const;

  /// Kills all LCMs, so that the journals are complete. Expects that the checker of commands finds
  /// no mistake.
  void ExpectHonestCommands();
  /// Expects that one subscription has received every row of one ledger. Rows may be lost only if
  /// MayExpireLeases(), and then each loss must be counted.
  void ExpectNoRowLost() const;
  void ExpectNeverLost(const std::string& process) const;
  /// Returns true if leases may have expired without a fault. Under a sanitizer, many slow programs
  /// may get no processor for longer than a lease lasts. Also true, with a message, if this machine
  /// ran no thread for a large part of a lease.
  [[nodiscard]] bool MayExpireLeases() const;
  /// Prints one line for the test: the injected fault, and the findings of the checkers.
  static void Tell(const std::string& line);

  const tendon::test::StallMeter stalls_;
  const tendon::test::Folder home_;
  Environment more_environment_;  ///< the environment of all programs that start from now on
  std::string gcm_address_;
  std::unique_ptr<Program> gcm_;
  std::unique_ptr<Program> robot_;
  std::unique_ptr<Program> desk_;
  const std::shared_ptr<ProcessWatch> watch_ = std::make_shared<ProcessWatch>();
  const std::shared_ptr<StreamChecker> stream_ = std::make_shared<StreamChecker>();
  std::unique_ptr<tendon::GcmClient> viewer_;

 private:
  template <typename Read>
  void ForEachJournal(const std::string& kind, Read read) const;
  /// Returns the number of executed commands of each client.
  [[nodiscard]] std::map<std::string, std::size_t> Executed() const;
};

/// Returns the edits of types in the process `hand`. The name of an edit is the name of the
/// component that has the edited type.
const std::vector<std::string>& Edits();

/// Returns true if all threads of the process have stopped after a SIGSTOP.
bool HasStopped(int pid);

/// Returns the names of all middlewares in this build, the default first.
std::vector<std::string> Middlewares();
inline std::string NameOfMiddleware(const testing::TestParamInfo<std::string>& info) {
  return info.param;
}

}  // namespace faults
