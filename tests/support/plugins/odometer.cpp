#include <tendon/manager/component_registry.h>
#include <tendon/task/periodic_task.h>

#include <chrono>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

namespace odometer {

using namespace std::chrono_literals;

enum class Mode : std::int32_t { kFault = -3, kIdle = 0, kMoving = 7 };

/// Doubles that are often printed wrong.
struct Edges {
  double zero = -0.0;
  double none = std::numeric_limits<double>::quiet_NaN();
  double endless = -std::numeric_limits<double>::infinity();
  double largest = std::numeric_limits<double>::max();
  double smallest = std::numeric_limits<double>::denorm_min();
  double sum = 0.1 + 0.2;
  float single = 0.1F;
  std::chrono::nanoseconds uptime = 2'000'000'000s + 123'456'789ns;
};

}  // namespace odometer

template <>
inline constexpr auto tendon::kPayload<odometer::Mode> =
    tendon::DescribeEnum("odometer.Mode", tendon::Enumerator{"fault", odometer::Mode::kFault},
                         tendon::Enumerator{"idle", odometer::Mode::kIdle},
                         tendon::Enumerator{"moving", odometer::Mode::kMoving});

template <>
inline constexpr auto tendon::kPayload<odometer::Edges> =
    tendon::Describe("odometer.Edges", tendon::Field{"zero", &odometer::Edges::zero},
                     tendon::Field{"none", &odometer::Edges::none},
                     tendon::Field{"endless", &odometer::Edges::endless},
                     tendon::Field{"largest", &odometer::Edges::largest},
                     tendon::Field{"smallest", &odometer::Edges::smallest},
                     tendon::Field{"sum", &odometer::Edges::sum, "m"},
                     tendon::Field{"single", &odometer::Edges::single, "m"},
                     tendon::Field{"uptime", &odometer::Edges::uptime});

namespace odometer {

/// States, and numbers beyond the precision of a double. The counter starts at the largest integer
/// below which every integer is exact as a double.
class Odometer final : public tendon::PeriodicTask {
 public:
  explicit Odometer(std::string name) : PeriodicTask(std::move(name), 10ms) {
    state_table().Add(count_, "Count");
    state_table().Add(stamp_, "Stamp");
    state_table().Add(last_, "Last");
    state_table().Add(ready_, "Ready");
    state_table().Add(mode_, "Mode");
    state_table().Add(edges_, "Edges");
    auto& control = AddProvidedInterface("Control");
    control.AddCommandWrite(&Odometer::SetCount, this, "SetCount");
    control.AddCommandReadState(state_table(), count_, "GetCount");
  }
  ~Odometer() override { Join(); }

 private:
  void Run() override {
    constexpr std::uint64_t kHalfPeriod = 25;  // rows
    ProcessQueuedCommands();
    ++rows_;
    ++count_;
    stamp_ += 10'000'000;
    ready_ = rows_ / kHalfPeriod % 2 == 1;
    const std::uint64_t phase = rows_ / kHalfPeriod % 3;
    mode_ = phase == 0 ? Mode::kIdle : phase == 1 ? Mode::kMoving : Mode::kFault;
  }
  void SetCount(std::uint64_t count) { count_ = count; }

  std::uint64_t rows_ = 0;
  std::uint64_t count_ = std::uint64_t{1} << 53U;
  std::int64_t stamp_ = 1'764'300'000'000'000'001;  // ns since 1970
  std::uint64_t last_ = std::numeric_limits<std::uint64_t>::max();
  bool ready_ = false;
  Mode mode_ = Mode::kIdle;
  Edges edges_;
};

}  // namespace odometer

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<odometer::Odometer>("Odometer");
}
