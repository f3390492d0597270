#include <tendon/manager/component_registry.h>
#include <tendon/task/periodic_task.h>

#include <cstdint>
#include <string>
#include <utility>

namespace {

using namespace std::chrono_literals;

/// Executes the received commands once per second.
class Clerk final : public tendon::PeriodicTask {
 public:
  explicit Clerk(std::string name) : PeriodicTask(std::move(name), 1s) {
    AddProvidedInterface("Desk").AddCommandWrite(&Clerk::Take, this, "Take");
  }
  ~Clerk() override { Join(); }

 private:
  void Run() override { ProcessQueuedCommands(); }
  void Take(const std::int32_t& /*paper*/) {}
};

/// Sends a thousand commands per second.
class Petitioner final : public tendon::PeriodicTask {
 public:
  explicit Petitioner(std::string name) : PeriodicTask(std::move(name), 1ms) {
    AddRequiredInterface("Desk").AddFunction(take_, "Take");
  }
  ~Petitioner() override { Join(); }

 private:
  void Run() override { (void)take_(paper_++); }

  tendon::WriteFunction<std::int32_t> take_;
  std::int32_t paper_ = 0;
};

}  // namespace

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<Clerk>("Clerk");
  registry.Add<Petitioner>("Petitioner");
}
