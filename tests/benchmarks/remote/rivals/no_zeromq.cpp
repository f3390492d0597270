#include <benchmarks/remote/rivals/rival.h>

namespace tendon::benchmark {

Rival ZeroMq() { return {.id = "R8-zmq", .name = "ZeroMQ", .missing = "libzmq3-dev"}; }

}  // namespace tendon::benchmark
