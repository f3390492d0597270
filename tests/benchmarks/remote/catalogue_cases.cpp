#include <benchmarks/remote/remote_system.h>
#include <support/wait.h>
#include <tendon/base/os/process.h>
#include <tendon/gcm/client.h>
#include <tendon/ice/ice_middleware.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <fstream>
#include <memory>
#include <sstream>
#include <vector>

namespace tendon::benchmark {
namespace {

constexpr std::size_t kCommandsOfAComponent = 100;

/// How much of a system there is: processes, and the components of each.
struct Size {
  int processes = 20;
  int components = 50;

  [[nodiscard]] std::size_t commands() const {
    return static_cast<std::size_t>(processes * components) * kCommandsOfAComponent;
  }
};

/// The commands a viewer has heard of. They only become more.
class CommandCounter final : public GcmListener {
 public:
  void OnSnapshot(const Catalog& catalog) override {
    std::size_t sum = 0;
    for (const auto& [name, entry] : catalog.processes()) {
      for (const auto& [component_name, component] : entry.components) sum += Of(component);
    }
    commands_ = sum;
  }
  void OnChanges(const std::vector<CatalogChange>& changes) override {
    for (const CatalogChange& change : changes) {
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

/// A line of /proc that is named so, of a process.
std::string LineOf(int pid, const std::string& file, const std::string& name) {
  std::ifstream lines("/proc/" + std::to_string(pid) + "/" + file);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(name)) return line.substr(name.size());
  }
  return {};
}

/// In bytes.
double ResidentMemoryOf(int pid) { return 1024 * std::stod(LineOf(pid, "status", "VmRSS:")); }

bool IsStopped(int pid) { return LineOf(pid, "status", "State:").find('T') != std::string::npos; }

/// What a GCM of its own needed to know a large system.
struct Catalogued {
  double duration = 0;  // ns, until a viewer knows all
  double memory = 0;    // bytes of the GCM
};

Catalogued LetThemJoin(RemoteSystem& system, const Size& size) {
  const std::string address = "127.0.0.1:" + std::to_string(FreePort());
  const Program gcm({TENDON_GCM, "serve", "--gcm", address}, system.environment());
  const auto counter = std::make_shared<CommandCounter>();
  GcmClient viewer(MakeIceMiddleware(Exposure::kLoopbackOnly), {.address = address}, counter);
  Require(EventuallyTrue([&] { return viewer.WaitUntilWatching().ok(); }), "no GCM is there");

  std::vector<std::unique_ptr<Program>> crowd;
  for (int i = 0; i < size.processes; ++i) {
    crowd.push_back(std::make_unique<Program>(
        Program::Words{os::ProgramFolder() / "report_crowd", "crowd" + std::to_string(i), address,
                       std::to_string(size.components)},
        system.environment()));
  }
  Require(EventuallyTrue([&] {
            return std::ranges::all_of(crowd,
                                       [](const auto& one) { return IsStopped(one->pid()); });
          }),
          "the processes do not start");

  const double before = ResidentMemoryOf(gcm.pid());
  const auto start = std::chrono::steady_clock::now();
  for (const auto& one : crowd) one->Signal(SIGCONT);
  Require(EventuallyTrue([&] { return counter->commands() >= size.commands(); }),
          "the viewer does not hear of all");
  const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
  return {took.count(), ResidentMemoryOf(gcm.pid()) - before};
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
