#include <core/seeded/seeded_atomics.h>

namespace tendon::seeded {
namespace {

constexpr std::size_t kNoFenceYet = 1'000'000;

// The state of the exploration. A simulation runs in one thread.
const Fault* active = nullptr;
std::array<std::size_t, MemoryModel::kMaxThreads> loads_since_fence;
std::array<std::size_t, MemoryModel::kMaxThreads> fences;

}  // namespace

simulation::Report Explore(const Fault& fault,
                           const std::function<void(simulation::Scenario&)>& build) {
  active = &fault;
  const auto report = simulation::Explore([&](simulation::Scenario& scenario) {
    loads_since_fence.fill(kNoFenceYet);
    fences.fill(0);
    build(scenario);
  });
  active = nullptr;
  return report;
}

Access Begin(Step step, std::memory_order order, MemoryModel::Location location) {
  const std::size_t thread = simulation::RunningThread();
  std::size_t& loads = loads_since_fence[thread];
  Access access{step, thread, location, loads, fences[thread], order};
  if (step == Step::kLoad) ++loads;
  if (step == Step::kFence) {
    loads = 0;
    ++fences[thread];
  }
  if (active->weaken && thread != simulation::kSetUp) active->weaken(access);
  return access;
}

void Forge(const Access& access, std::uint64_t& value) {
  if (active->forge && access.thread != simulation::kSetUp) active->forge(access, value);
}

}  // namespace tendon::seeded
