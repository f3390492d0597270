#pragma once

#include <memory>
#include <string>

#include "support/program.h"

namespace faults {

/// Two network namespaces with a cable between them. They are in a user namespace, so that the test
/// does not need root.
class Islands {
 public:
  enum class Cut { kBothWays, kFromHere, kFromThere };

  Islands();

  /// Returns false if this machine does not allow the namespaces; reason() says why. In this case,
  /// call no other function.
  [[nodiscard]] bool ok() const { return reason_.empty(); }
  [[nodiscard]] const std::string& reason() const { return reason_; }

  /// Returns the first words of a command line that runs in one of the namespaces.
  [[nodiscard]] Program::Words Here() const;
  [[nodiscard]] Program::Words There() const;
  static constexpr const char* kHere = "10.77.0.1";
  static constexpr const char* kThere = "10.77.0.2";

  /// From now on, drops all data in this direction. Neither end is notified.
  void Make(Cut cut) const;
  void Heal() const;

 private:
  void Begin();
  /// Runs a shell script on an island.
  static Outcome Do(Program::Words island, const std::string& script);
  void Aim(const Program::Words& island, const std::string& peer, const std::string& device,
           const std::string& address) const;

  std::unique_ptr<Program> here_;
  std::unique_ptr<Program> there_;
  std::string reason_;
};

}  // namespace faults
