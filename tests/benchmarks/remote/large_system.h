#pragma once

#include <benchmarks/remote/remote_system.h>
#include <support/program.h>

#include <memory>
#include <string>
#include <vector>

namespace tendon::benchmark {

/// A GCM of its own, and processes of equal components that are ready to join it.
class LargeSystem {
 public:
  LargeSystem(const RemoteSystem& system, int processes, int components_of_each);

  [[nodiscard]] const std::string& address() const { return address_; }
  /// Of the GCM, resident; in bytes.
  [[nodiscard]] double MemoryOfGcm() const;

  /// All at once; returns while they do.
  void Join();

 private:
  const std::string address_;
  const Program gcm_;
  std::vector<std::unique_ptr<Program>> crowd_;
};

}  // namespace tendon::benchmark
