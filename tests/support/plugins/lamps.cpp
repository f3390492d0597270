#include <tendon/manager/component_registry.h>
#include <tendon/task/periodic_task.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

/// A plug-in for tests of remote requests.
namespace lamps {

using namespace std::chrono_literals;

struct LampConfiguration {
  double brightness = 0.5;
};

/// A task whose constructor fails if its colour is black.
class Lamp final : public tendon::PeriodicTask {
 public:
  using Configuration = LampConfiguration;
  Lamp(std::string name, const Configuration& chosen)
      : PeriodicTask(std::move(name), 5ms), brightness_(chosen.brightness) {
    if (brightness_ == 0.0) throw std::runtime_error("a black lamp is none");
    state_table().Add(brightness_, "Brightness");
    auto& control = AddProvidedInterface("Control");
    control.AddCommandReadState(state_table(), brightness_, "GetBrightness");
  }
  ~Lamp() override { Join(); }

 private:
  void Run() override {}

  double brightness_;
};

class Switch final : public tendon::Component {
 public:
  explicit Switch(std::string name) : Component(std::move(name)) {
    AddRequiredInterface("Lamp").AddFunction(get_, "GetBrightness");
  }

 private:
  tendon::ReadFunction<double> get_;
};

struct GateConfiguration {
  std::string file;
};

/// A component whose constructor creates the file `file`.reached, and then waits until `file`
/// exists.
class Gate final : public tendon::Component {
 public:
  using Configuration = GateConfiguration;
  Gate(std::string name, const Configuration& chosen) : Component(std::move(name)) {
    std::ofstream(chosen.file + ".reached") << "here";
    while (!std::filesystem::exists(chosen.file)) std::this_thread::sleep_for(1ms);
  }
};

/// A task whose Startup() creates the file `file`.reached, and then waits until `file` exists.
class SlowStarter final : public tendon::PeriodicTask {
 public:
  using Configuration = GateConfiguration;
  SlowStarter(std::string name, const Configuration& chosen)
      : PeriodicTask(std::move(name), 5ms), file_(chosen.file) {
    state_table().Add(cycles_, "Cycles");
  }
  ~SlowStarter() override { Join(); }

 private:
  void Startup() override {
    std::ofstream(file_ + ".reached") << "here";
    while (!std::filesystem::exists(file_)) std::this_thread::sleep_for(1ms);
  }
  void Run() override { ++cycles_; }

  const std::string file_;
  std::int32_t cycles_ = 0;
};

/// A task whose Startup() fails as soon as its file exists.
class Refuser final : public tendon::PeriodicTask {
 public:
  using Configuration = GateConfiguration;
  Refuser(std::string name, const Configuration& chosen)
      : PeriodicTask(std::move(name), 5ms), file_(chosen.file) {}
  ~Refuser() override { Join(); }

 private:
  void Startup() override {
    if (std::filesystem::exists(file_)) throw std::runtime_error("it will not");
  }
  void Run() override {}

  const std::string file_;
};

/// A task whose cycle creates the file `file`.reached, and then waits until `file` exists.
class Hung final : public tendon::PeriodicTask {
 public:
  using Configuration = GateConfiguration;
  Hung(std::string name, const Configuration& chosen)
      : PeriodicTask(std::move(name), 5ms), file_(chosen.file) {
    AddRequiredInterface("Lamp").AddFunction(get_, "GetBrightness");
  }
  ~Hung() override { Join(); }

 private:
  void Run() override {
    std::ofstream(file_ + ".reached") << "here";
    while (!std::filesystem::exists(file_)) std::this_thread::sleep_for(1ms);
  }

  const std::string file_;
  tendon::ReadFunction<double> get_;
};

/// A component whose Configure() waits until its file exists, in the thread of the caller.
class SlowConfigurer final : public tendon::Component {
 public:
  using Configuration = GateConfiguration;
  SlowConfigurer(std::string name, const Configuration& chosen)
      : Component(std::move(name)), file_(chosen.file) {}

 private:
  void Configure() override {
    while (!std::filesystem::exists(file_)) std::this_thread::sleep_for(1ms);
  }

  const std::string file_;
};

}  // namespace lamps

template <>
inline constexpr auto tendon::kPayload<lamps::LampConfiguration> = tendon::Describe(
    "lamps.LampConfiguration",
    tendon::Field{"brightness", &lamps::LampConfiguration::brightness}.Within(0, 1));

template <>
inline constexpr auto tendon::kPayload<lamps::GateConfiguration> = tendon::Describe(
    "lamps.GateConfiguration", tendon::Field{"file", &lamps::GateConfiguration::file});

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<lamps::Lamp>("Lamp");
  registry.Add<lamps::Switch>("Switch");
  registry.Add<lamps::Gate>("Gate");
  registry.Add<lamps::SlowStarter>("SlowStarter");
  registry.Add<lamps::Refuser>("Refuser");
  registry.Add<lamps::Hung>("Hung");
  registry.Add<lamps::SlowConfigurer>("SlowConfigurer");
}
