#pragma once

#include <benchmarks/remote/remote_system.h>
#include <support/program.h>

#include <memory>
#include <string>
#include <vector>

namespace tendon::benchmark {

/// Its own GCM, and processes of equal components that are ready to join this GCM.
class LargeSystem {
 public:
  LargeSystem(const RemoteSystem& system, int processes, int components_of_each);

  [[nodiscard]] const std::string& address() const { return address_; }
  /// Returns the resident memory of the GCM in bytes.
  [[nodiscard]] double MemoryOfGcm() const;

  /// Lets all processes join at once. Returns while they are joining.
  void Join();

 private:
  const std::string address_;
  const Program gcm_;
  std::vector<std::unique_ptr<Program>> crowd_;
};

}  // namespace tendon::benchmark
