#include <tendon/manager/component_registry.h>
#include <tendon/task/periodic_task.h>

#include <cstdint>
#include <string>
#include <utility>

/// A plug-in that is built twice, so that a test can see which version runs.
namespace test {

struct Generation {
  std::int32_t number = 0;
};

}  // namespace test

template <>
inline constexpr auto tendon::kPayload<test::Generation> =
    tendon::Describe("test.Generation", tendon::Field{"number", &test::Generation::number});

namespace test {

using namespace std::chrono_literals;

/// Records in each cycle the generation of its code.
class Ageing final : public tendon::PeriodicTask {
 public:
  explicit Ageing(std::string name) : PeriodicTask(std::move(name), 1ms) {
    state_table().Add(generation_, "Generation");
  }
  ~Ageing() override { Join(); }

 private:
  void Run() override { generation_.number = TENDON_TEST_GENERATION; }

  Generation generation_;
};

#if TENDON_TEST_GENERATION > 1
class Newcomer final : public tendon::Component {
 public:
  explicit Newcomer(std::string name) : Component(std::move(name)) {}
};
#endif

}  // namespace test

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<test::Ageing>("Ageing");
#if TENDON_TEST_GENERATION > 1
  registry.Add<test::Newcomer>("Newcomer");
#endif
}
