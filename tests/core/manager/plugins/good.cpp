#include <tendon/manager/component_registry.h>

namespace test {

struct LampConfiguration {
  double brightness = 0.5;
};

class Lamp final : public tendon::Component {
 public:
  using Configuration = LampConfiguration;
  Lamp(std::string name, const Configuration& /*chosen*/) : Component(std::move(name)) {}
};

class Socket final : public tendon::Component {
 public:
  explicit Socket(std::string name) : Component(std::move(name)) {}
};

}  // namespace test

template <>
inline constexpr auto tendon::kPayload<test::LampConfiguration> = tendon::Describe(
    "test.LampConfiguration",
    tendon::Field{"brightness", &test::LampConfiguration::brightness}.Within(0, 1));

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<test::Lamp>("Lamp");
  registry.Add<test::Socket>("Socket");
}
