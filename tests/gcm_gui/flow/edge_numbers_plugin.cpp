#include <tendon/manager/component_registry.h>
#include <tendon/payload/payload.h>
#include <tendon/task/periodic_task.h>

#include <chrono>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

namespace edges {

enum class Mode : std::int32_t { kOff = 0, kManual = 2, kAutomatic = 7 };

/// Numbers that are difficult to draw.
struct Numbers {
  double largest = std::numeric_limits<double>::max();
  /// Alternates between the largest double and its negative.
  double turning = std::numeric_limits<double>::max();
  double smallest = std::numeric_limits<double>::denorm_min();
  std::int64_t counter = 9'000'000'000;
  std::uint64_t stamp = 0;  ///< ns since 1970
  double unix_time = 0;     ///< s
};

/// States with very different numbers, at 2 Hz.
struct States {
  Mode mode = Mode::kOff;
  bool is_ready = false;
};

}  // namespace edges

template <>
inline constexpr auto tendon::kPayload<edges::Mode> =
    tendon::DescribeEnum("edges.Mode", tendon::Enumerator{"off", edges::Mode::kOff},
                         tendon::Enumerator{"manual", edges::Mode::kManual},
                         tendon::Enumerator{"automatic", edges::Mode::kAutomatic});

template <>
inline constexpr auto tendon::kPayload<edges::Numbers> =
    tendon::Describe("edges.Numbers", tendon::Field{"largest", &edges::Numbers::largest, "rad"},
                     tendon::Field{"turning", &edges::Numbers::turning, "V"},
                     tendon::Field{"smallest", &edges::Numbers::smallest, "A"},
                     tendon::Field{"counter", &edges::Numbers::counter},
                     tendon::Field{"stamp", &edges::Numbers::stamp, "ns"},
                     tendon::Field{"unix_time", &edges::Numbers::unix_time, "s"});

template <>
inline constexpr auto tendon::kPayload<edges::States> =
    tendon::Describe("edges.States", tendon::Field{"mode", &edges::States::mode},
                     tendon::Field{"is_ready", &edges::States::is_ready});

namespace edges {
namespace {

using namespace std::chrono_literals;

class FastNumbers final : public tendon::PeriodicTask {
 public:
  explicit FastNumbers(std::string name) : PeriodicTask(std::move(name), 10ms) {
    state_table().Add(numbers_, "Numbers");
  }

 private:
  void Run() override {
    ProcessQueuedCommands();
    ++numbers_.counter;
    numbers_.turning = -numbers_.turning;
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    numbers_.stamp = static_cast<std::uint64_t>(std::chrono::nanoseconds(now).count());
    numbers_.unix_time = std::chrono::duration<double>(now).count();
  }

  Numbers numbers_;
};

class SlowStates final : public tendon::PeriodicTask {
 public:
  explicit SlowStates(std::string name) : PeriodicTask(std::move(name), 500ms) {
    state_table().Add(states_, "States");
  }

 private:
  void Run() override {
    ProcessQueuedCommands();
    states_.is_ready = !states_.is_ready;
    const bool is_off = states_.mode == Mode::kOff;
    states_.mode = is_off ? Mode::kAutomatic : states_.is_ready ? Mode::kManual : Mode::kOff;
  }

  States states_;
};

}  // namespace
}  // namespace edges

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<edges::FastNumbers>("FastNumbers");
  registry.Add<edges::SlowStates>("SlowStates");
}
