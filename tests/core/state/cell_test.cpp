#include <core/state/sample.h>
#include <gtest/gtest.h>
#include <tendon/state/cell.h>

#include <array>
#include <cstdint>

namespace tendon {
namespace test {

struct Pose {
  std::array<double, 3> position{};
  std::array<double, 4> orientation{};
};
struct Arm {
  Pose base;
  std::array<float, 2> grip{};
};
struct Swapped {
  std::int32_t first = 0;
  std::int32_t second = 0;
};
struct Switch {
  bool is_on = false;
};

}  // namespace test

template <>
inline constexpr auto kPayload<test::Pose> = Describe("test.Pose",
                                                      Field{"position", &test::Pose::position, "m"},
                                                      Field{"orientation",
                                                            &test::Pose::orientation});
template <>
inline constexpr auto kPayload<test::Arm> = Describe("test.Arm", Field{"base", &test::Arm::base},
                                                     Field{"grip", &test::Arm::grip});
template <>
inline constexpr auto kPayload<test::Swapped> = Describe("test.Swapped",
                                                         Field{"second", &test::Swapped::second},
                                                         Field{"first", &test::Swapped::first});
template <>
inline constexpr auto kPayload<test::Switch> = Describe("test.Switch",
                                                        Field{"is_on", &test::Switch::is_on});

namespace {

TEST(Cell, NumbersWithoutGapsHaveTheWireLayout) {
  EXPECT_TRUE(LiesAsOnWire(0.0));
  EXPECT_TRUE(LiesAsOnWire(std::array<std::int16_t, 3>{}));
  EXPECT_TRUE(LiesAsOnWire(test::Pose{}));
  EXPECT_TRUE(LiesAsOnWire(test::Arm{}));
}

TEST(Cell, AGapOrAnotherOrderDiffersFromTheWireLayout) {
  EXPECT_FALSE(LiesAsOnWire(test::Sample{}));
  EXPECT_FALSE(LiesAsOnWire(test::Swapped{}));
}

TEST(Cell, TypesCheckedOnDecodingHaveNoWireLayout) {
  EXPECT_FALSE(LiesAsOnWire(true));
  EXPECT_FALSE(LiesAsOnWire(test::Switch{}));
  EXPECT_FALSE(LiesAsOnWire(test::Gear::kLow));
  EXPECT_FALSE(LiesAsOnWire(None{}));
}

TEST(Cell, LoadsNoMoreBytesThanPresent) {
  const std::array<RowRing<>::Word, 2> cell{0x0807060504030201, 0xffff'ffff'ff0b'0a09};
  std::array<std::uint8_t, 12> bytes{};

  LoadCell<11>(cell.data(), reinterpret_cast<std::byte*>(bytes.data()));

  EXPECT_EQ(bytes, (std::array<std::uint8_t, 12>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 0}));
}

}  // namespace
}  // namespace tendon
