#include <benchmarks/remote/large_system.h>
#include <support/wait.h>
#include <tendon/gcm/client.h>
#include <tendon/ice/ice_middleware.h>

#include <atomic>
#include <memory>
#include <vector>

namespace tendon::benchmark {
namespace {

constexpr std::size_t kCommandsOfAComponent = 100;

/// The size of a system: the number of processes, and of components in each process.
struct Size {
  int processes = 20;
  int components = 50;

  [[nodiscard]] std::size_t commands() const {
    return static_cast<std::size_t>(processes * components) * kCommandsOfAComponent;
  }
};

/// Counts the commands that a viewer knows. The number only grows.
class CommandCounter final : public GcmListener {
 public:
  void OnSnapshot(const Catalogue& catalogue) override {
    std::size_t sum = 0;
    for (const auto& [name, entry] : catalogue.processes()) {
      for (const auto& [component_name, component] : entry.components) sum += Of(component);
    }
    commands_ = sum;
  }
  void OnChanges(const std::vector<CatalogueChange>& changes) override {
    for (const CatalogueChange& change : changes) {
      for (const ComponentDescription& component : change.components) commands_ += Of(component);
    }
  }
  void OnGcmLost(const Error& /*reason*/) override {}

  [[nodiscard]] std::size_t commands() const { return commands_; }

 private:
  static std::size_t Of(const ComponentDescription& component) {
    std::size_t sum = 0;
    for (const ProvidedDescription& provided : component.provided) sum += provided.commands.size();
    return sum;
  }

  std::atomic<std::size_t> commands_ = 0;
};

/// The cost for a new GCM to learn the catalogue of a large system.
struct Catalogued {
  double duration = 0;  // ns, until a viewer knows the whole catalogue
  double memory = 0;    // bytes used by the GCM
};

Catalogued LetThemJoin(const RemoteSystem& system, const Size& size) {
  LargeSystem large(system, size.processes, size.components);
  const auto counter = std::make_shared<CommandCounter>();
  GcmClient viewer(MakeIceMiddleware(Exposure::kLoopbackOnly), {.address = large.address()},
                   counter);
  Require(EventuallyTrue([&] { return viewer.WaitUntilWatching().ok(); }), "no GCM is there");

  const double before = large.MemoryOfGcm();
  const auto start = std::chrono::steady_clock::now();
  large.Join();
  Require(EventuallyTrue([&] { return counter->commands() >= size.commands(); }),
          "the viewer does not hear of all");
  const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
  return {took.count(), large.MemoryOfGcm() - before};
}

}  // namespace

std::vector<Case> CatalogueCases(const Effort& effort, const TheSystem& system) {
  const Size size = effort.is_tiny ? Size{2, 3} : Size{};
  const auto joined = [system, size, found = std::make_shared<std::optional<Catalogued>>()] {
    if (!*found) *found = LetThemJoin(system(), size);
    return **found;
  };
  constexpr double kMiB = 1024 * 1024;
  return {
      {.id = "G1",
       .what = "20 processes of 50 components each join: a viewer knows 100k commands",
       .gate = 1e9,
       .stretch = 0.25e9,
       .repetition = [joined] { return std::optional(Pair{.ours = joined().duration}); },
       .runs_once = true},
      {.id = "G2",
       .what = "memory of the GCM for them",
       .unit = "MiB",
       .gate = 25,
       .stretch = 12,
       .repetition = [joined] { return std::optional(Pair{.ours = joined().memory / kMiB}); },
       .runs_once = true},
  };
}

}  // namespace tendon::benchmark
