#include <gtest/gtest.h>
#include <tendon/payload/codec.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/payload/layout.h>
#include <tendon/payload/schema.h>
#include <tendon/state/cell.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace {

struct Tip {
  double x = 0;
  double y = 0;
};

/// One member of each kind; several of them could be initialised by more than one value.
struct Limb {
  std::array<double, 7> position{};
  std::vector<std::string> names{};
  Tip tip{};
  std::chrono::milliseconds age{};
  bool is_on = false;
};
/// The same, described with pointers to its members.
struct LongLimb : Limb {};

struct Empty {};

struct Many {
  int a = 1, b = 2, c = 3, d = 4, e = 5, f = 6, g = 7, h = 8, i = 9, j = 10, k = 11, l = 12;
  int m = 13, n = 14, o = 15, p = 16, q = 17, r = 18, s = 19, t = 20, u = 21, v = 22, w = 23,
      x = 24;
};

}  // namespace

template <>
inline constexpr auto tendon::kPayload<Tip> = tendon::Describe<Tip>(
    "test.Tip", tendon::FieldName("x in m").Within(0, 2).Help("Forwards."), "y in m");
template <>
inline constexpr auto tendon::kPayload<Limb> = tendon::Describe<Limb>("test.Limb",
                                                                      "position in rad", "names",
                                                                      "tip", "age", "is_on");
template <>
inline constexpr auto tendon::kPayload<LongLimb> = tendon::Describe(
    "test.Limb", tendon::Field{"position", &LongLimb::position, "rad"},
    tendon::Field{"names", &LongLimb::names}, tendon::Field{"tip", &LongLimb::tip},
    tendon::Field{"age", &LongLimb::age}, tendon::Field{"is_on", &LongLimb::is_on});
template <>
inline constexpr auto tendon::kPayload<Empty> = tendon::Describe<Empty>("test.Empty");
template <>
inline constexpr auto tendon::kPayload<Many> = tendon::Describe<Many>("test.Many", "a", "b", "c",
                                                                      "d", "e", "f", "g", "h", "i",
                                                                      "j", "k", "l", "m", "n", "o",
                                                                      "p", "q", "r", "s", "t", "u",
                                                                      "v", "w", "x");

namespace tendon {
namespace {

TEST(Aggregate, HasTheSchemaAndTheFingerprintOfTheLongForm) {
  EXPECT_EQ(SchemaOf<Limb>().TextWithHelp(), SchemaOf<LongLimb>().TextWithHelp());
  EXPECT_EQ(FingerprintOf<Limb>(), FingerprintOf<LongLimb>());
  EXPECT_EQ(SchemaOf<Empty>().Text(), "struct test.Empty {\n}");
}

TEST(Aggregate, HasTheLayoutOfTheLongForm) { EXPECT_EQ(LayoutOf<Limb>(), LayoutOf<LongLimb>()); }

TEST(Aggregate, KeepsUnitsRangesAndHelp) {
  EXPECT_EQ(SchemaOf<Tip>().TextWithHelp(),
            "struct test.Tip {\n"
            "  # Forwards.\n"
            "  @ 0 to 2\n"
            "  x: float64 in m\n"
            "  y: float64 in m\n"
            "}");
}

TEST(Aggregate, IsEncodedAndDecodedLikeTheLongForm) {
  LongLimb sent;
  sent.position[6] = 0.5;
  sent.names = {"left", "right"};
  sent.tip = {1, 2};
  sent.age = std::chrono::milliseconds(1500);
  sent.is_on = true;
  std::vector<std::byte> long_body;
  std::vector<std::byte> body;
  Encode(sent, long_body);
  Encode(static_cast<const Limb&>(sent), body);
  EXPECT_EQ(body, long_body);

  Limb got;
  ASSERT_TRUE(Decode(body, got));

  EXPECT_EQ(got.position, sent.position);
  EXPECT_EQ(got.names, sent.names);
  EXPECT_EQ(got.tip.y, 2);
  EXPECT_EQ(got.age, sent.age);
  EXPECT_TRUE(got.is_on);
}

TEST(Aggregate, LiesInATableAsOnTheWire) { EXPECT_TRUE(LiesAsOnWire(Tip{})); }

TEST(Aggregate, HasUpTo24Fields) {
  int sum = 0;
  payload::WithFields<Many>([&](const auto&... field) {
    static_assert(sizeof...(field) == 24);
    const Many many;
    ((sum = 2 * sum + field.Of(many)), ...);
  });

  int expected = 0;
  for (int i = 1; i <= 24; ++i) expected = 2 * expected + i;
  EXPECT_EQ(sum, expected);
}

}  // namespace
}  // namespace tendon
