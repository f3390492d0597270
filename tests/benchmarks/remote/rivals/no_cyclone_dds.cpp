#include <benchmarks/remote/rivals/rival.h>

namespace tendon::benchmark {

Rival CycloneDds() {
  return {.id = "R8-dds", .name = "CycloneDDS", .stretch = 1.05, .missing = "cyclonedds-dev"};
}

}  // namespace tendon::benchmark
