#include <benchmarks/remote/rivals/rival.h>

namespace tendon::benchmark {

std::vector<Rival> Rivals() { return {ZeroMq(), CycloneDds()}; }

}  // namespace tendon::benchmark
