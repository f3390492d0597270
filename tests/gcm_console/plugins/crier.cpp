#include <tendon/manager/component_registry.h>
#include <tendon/payload/payload.h>
#include <tendon/task/periodic_task.h>

#include <cstdint>
#include <string>
#include <utility>

namespace hall {

enum class Tone : std::int32_t { kLow, kMiddle, kHigh };

struct Saying {
  std::string text;
  Tone tone = Tone::kMiddle;
  bool is_loud = false;
};

struct CrierConfiguration {
  Tone tone = Tone::kMiddle;
  double volume = 0.5;  // 0 to 1
};

}  // namespace hall

template <>
inline constexpr auto tendon::kPayload<hall::Tone> =
    tendon::DescribeEnum("hall.Tone", tendon::Enumerator{"low", hall::Tone::kLow},
                         tendon::Enumerator{"middle", hall::Tone::kMiddle},
                         tendon::Enumerator{"high", hall::Tone::kHigh});
template <>
inline constexpr auto tendon::kPayload<hall::Saying> = tendon::Describe(
    "hall.Saying", tendon::Field{"text", &hall::Saying::text},
    tendon::Field{"tone", &hall::Saying::tone}, tendon::Field{"loud", &hall::Saying::is_loud});
template <>
inline constexpr auto tendon::kPayload<hall::CrierConfiguration> = tendon::Describe(
    "hall.CrierConfiguration", tendon::Field{"tone", &hall::CrierConfiguration::tone},
    tendon::Field{"volume", &hall::CrierConfiguration::volume});

namespace {

using namespace std::chrono_literals;

/// Raises the requested number of events at once, and returns the text that it receives.
class Crier final : public tendon::PeriodicTask {
 public:
  using Configuration = hall::CrierConfiguration;

  explicit Crier(std::string name, const Configuration& /*configuration*/ = {})
      : PeriodicTask(std::move(name), 1ms) {
    auto& voice = AddProvidedInterface("Voice");
    voice.AddCommandWrite(&Crier::Cry, this, "Cry");
    voice.AddCommandVoid(&Crier::Fall, this, "Fall");
    voice.AddCommandWriteReturn(&Crier::Repeat, this, "Repeat");
    voice.AddCommandWriteReturn(&Crier::Sing, this, "Sing");
    voice.AddEvent(cried_, "Cried");
    voice.AddEvent(fell_, "Fell");
  }
  ~Crier() override { Join(); }

 private:
  void Run() override { ProcessQueuedCommands(); }
  void Cry(const std::int32_t& times) {
    for (std::int32_t i = 1; i <= times; ++i) cried_(i);
  }
  void Fall() { fell_(); }
  void Repeat(const hall::Saying& saying, hall::Saying& same) { same = saying; }
  void Sing(const hall::Tone& tone, hall::Tone& same) { same = tone; }

  tendon::WriteEvent<std::int32_t> cried_;
  tendon::VoidEvent fell_;
};

}  // namespace

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<Crier>("Crier");
}
