#include <core/volume/item.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <string_view>

#include "support/machine/sanitized.h"

namespace {

/// Ten million. With a sanitizer, fewer items, so that the test takes about as long.
std::uint64_t DefaultItems() { return tendon::test::IsSanitized() ? 1'000'000 : 10'000'000; }

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  tendon::volume::items = DefaultItems();
  for (int i = 1; i < argc; ++i) {
    constexpr std::string_view kOption = "--items=";
    const std::string_view argument = argv[i];
    char* end = nullptr;
    if (argument.starts_with(kOption)) {
      tendon::volume::items = std::strtoull(argv[i] + kOption.size(), &end, 10);
    }
    if (end == nullptr || *end != '\0' || tendon::volume::items == 0) {
      std::cerr << "volume_tests: unknown '" << argument << "'; expected --items=1000000000\n";
      return 2;
    }
  }
  return RUN_ALL_TESTS();
}
