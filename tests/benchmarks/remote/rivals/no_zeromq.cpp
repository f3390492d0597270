#include <benchmarks/remote/rivals/rival.h>

namespace tendon::benchmark {

Rival ZeroMq() {
  return {.id = "R8-zmq", .name = "ZeroMQ", .stretch = 0.75, .missing = "libzmq3-dev"};
}

}  // namespace tendon::benchmark
