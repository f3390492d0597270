#include <tendon/payload/payload.h>

struct Inner {};
struct Outer {
  Inner inner;
};

template <>
inline constexpr auto tendon::kPayload<Outer> =
    tendon::Describe("test.Outer", tendon::Field{"inner", &Outer::inner});

static_assert(tendon::Payload<Outer>);
