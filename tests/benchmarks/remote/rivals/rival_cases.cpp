#include <benchmarks/remote/remote_system.h>
#include <benchmarks/remote/rivals/rival.h>

namespace tendon::benchmark {

std::vector<Case> RivalCases(const Effort& effort, const TheSystem& system) {
  const std::uint64_t reads = effort.Times(200);
  std::vector<Case> all;
  for (const Rival& rival : Rivals()) {
    const std::string what = "remote read / " + rival.name;
    if (!rival.missing.empty()) {
      all.push_back({.id = rival.id,
                     .what = what + ": not built: package " + rival.missing + " missing",
                     .stretch = rival.stretch,
                     .repetition = [] { return std::optional<Pair>(); }});
      continue;
    }
    const auto read_theirs = [=, id = rival.id](RemoteSystem& both) {
      RivalClient& client = both.rival(id);
      return NanosecondsEach(reads, [&](std::uint64_t) {
        Message reply{};
        client.Read(reply);
        Use(reply);
      });
    };
    all.push_back({.id = rival.id,
                   .what = what + " request and answer, 64 B",
                   .stretch = rival.stretch,
                   .repetition = SideBySide(
                       Between(system, [=](auto& both) { return ReadJoints(both, reads); }),
                       Between(system, read_theirs))});
  }
  return all;
}

}  // namespace tendon::benchmark
