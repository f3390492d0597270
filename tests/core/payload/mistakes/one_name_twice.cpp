#include <tendon/payload/payload.h>

struct Pair {
  int a = 0;
  int b = 0;
};

template <>
inline constexpr auto tendon::kPayload<Pair> = tendon::Describe("test.Pair",
                                                                tendon::Field{"a", &Pair::a},
                                                                tendon::Field{"a", &Pair::b});
