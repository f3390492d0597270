#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "targets.h"

/// The entry points of libFuzzer: tendon-fuzz --target=json CORPUS [OPTION]...
namespace {

const fuzz::Target* chosen = nullptr;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  constexpr std::string_view kOption = "--target=";
  for (int i = 1; i < *argc; ++i) {
    const std::string_view word = (*argv)[i];
    if (!word.starts_with(kOption)) continue;
    for (const fuzz::Target& target : fuzz::Targets()) {
      if (target.name == word.substr(kOption.size())) chosen = &target;
    }
  }
  if (chosen != nullptr) return 0;
  std::fputs("tendon-fuzz --target=NAME CORPUS; the names are:\n", stderr);
  for (const fuzz::Target& target : fuzz::Targets()) {
    std::fprintf(stderr, "  %s\n", std::string(target.name).c_str());
  }
  std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  chosen->run(std::as_bytes(std::span(data, size)));
  return 0;
}
