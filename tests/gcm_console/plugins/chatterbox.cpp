#include <tendon/base/log.h>
#include <tendon/manager/component_registry.h>
#include <tendon/task/periodic_task.h>

#include <string>
#include <utility>

namespace {

using namespace std::chrono_literals;

/// Logs 100,000 lines a second.
class Chatterbox final : public tendon::PeriodicTask {
 public:
  explicit Chatterbox(std::string name) : PeriodicTask(std::move(name), 1ms) {}
  ~Chatterbox() override { Join(); }

 private:
  void Run() override {
    for (int i = 0; i < 100; ++i) tendon::Log(tendon::LogLevel::kInfo, name(), "and another thing");
  }
};

}  // namespace

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<Chatterbox>("Chatterbox");
}
