#include <components/counter/counter.h>
#include <components/counter/counter_client.h>
#include <tendon/manager/local_manager.h>

#include <iostream>
#include <thread>

using namespace std::chrono_literals;

int main() {
  tendon::LocalManager manager;
  auto& counter = manager.Add<counter::Counter>("counter");
  manager.Add<counter::CounterClient>("client");

  const auto connected = manager.Connect({"client", "Counter"}, {"counter", "Control"});
  if (!connected) {
    std::cerr << connected.error().message << '\n';
    return 1;
  }
  if (const auto started = manager.StartAll(); !started) {
    std::cerr << started.error().message << '\n';
    return 1;
  }
  std::this_thread::sleep_for(2s);

  const auto& table = *counter.tables().front();
  std::cout << "the counter has counted " << table.next_tick() << " times\n";
}
