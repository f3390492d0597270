#include <docs/tutorials/wave/tuner.h>
#include <docs/tutorials/wave/wave.h>
#include <tendon/manager/local_manager.h>

#include <iostream>
#include <thread>

int main() {
  tendon::LocalManager manager;
  manager.Add<Wave>("wave");
  auto& tuner = manager.Add<Tuner>("tuner");

  const auto connected = manager.Connect({"tuner", "Wave"}, {"wave", "Control"});
  if (!connected) {
    std::cerr << connected.error().message << '\n';
    return 1;
  }
  if (const auto started = manager.StartAll(); !started) {
    std::cerr << started.error().message << '\n';
    return 1;
  }
  std::this_thread::sleep_for(1s);

  const auto& table = *tuner.tables().front();
  std::cout << "the tuner has run " << table.next_tick() << " cycles\n";
}
