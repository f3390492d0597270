#include <gcm_gui/plot/series/exact_number.h>
#include <gtest/gtest.h>

#include <limits>

namespace tendon::gui {
namespace {

constexpr std::int64_t kMin = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t kMax = std::numeric_limits<std::int64_t>::max();
constexpr std::uint64_t kMaxUnsigned = std::numeric_limits<std::uint64_t>::max();

TEST(ExactNumber, PrintsAllDigits) {
  EXPECT_EQ(ExactNumber::Signed(kMin).text(), "-9223372036854775808");
  EXPECT_EQ(ExactNumber::Unsigned(kMaxUnsigned).text(), "18446744073709551615");
  EXPECT_EQ(ExactNumber(0.1).text(), "0.1");
}

TEST(ExactNumber, ComparesByItsKind) {
  EXPECT_TRUE(ExactNumber::Signed(-1).isBelow(ExactNumber::Signed(0)));
  EXPECT_FALSE(ExactNumber::Unsigned(kMaxUnsigned).isBelow(ExactNumber::Unsigned(0)));
  EXPECT_TRUE(ExactNumber(-0.5).isBelow(0.5));
}

TEST(DifferenceText, IsExactOverAllIntegers) {
  EXPECT_EQ(DifferenceText(ExactNumber::Signed(kMin), ExactNumber::Signed(kMax)),
            "18446744073709551615");
  EXPECT_EQ(DifferenceText(ExactNumber::Unsigned(7), ExactNumber::Unsigned(4)), "-3");
}

TEST(DistanceFrom, SeparatesNeighboursThatDoublesCannot) {
  const DistanceFrom from_stamp(ExactNumber::Kind::kSigned, 1.7e18);
  EXPECT_EQ(from_stamp(1'700'000'000'000'000'001), 1);
  EXPECT_EQ(from_stamp(1'699'999'999'999'999'999), -1);

  const DistanceFrom from_end(ExactNumber::Kind::kUnsigned, 0x1.fffffffffffffp63);
  EXPECT_EQ(from_end(kMaxUnsigned), 2047);
}

TEST(DistanceFrom, IsExactFromTheBaseAboveAllIntegers) {
  const DistanceFrom from_end(ExactNumber::Kind::kUnsigned, 0x1p64);
  EXPECT_EQ(from_end(kMaxUnsigned), -1);
  EXPECT_EQ(from_end(kMaxUnsigned - 1), -2);
  EXPECT_EQ(from_end(0), -0x1p64);

  const DistanceFrom from_signed_end(ExactNumber::Kind::kSigned, 0x1p63);
  EXPECT_EQ(from_signed_end(static_cast<std::uint64_t>(kMax)), -1);
  EXPECT_EQ(from_signed_end(static_cast<std::uint64_t>(kMax) - 1), -2);
  EXPECT_EQ(from_signed_end(0), -0x1p63);
  EXPECT_EQ(from_signed_end(static_cast<std::uint64_t>(kMin)), -0x1p64);
}

TEST(DistanceFrom, FitsADoubleForAnyWordAndBase) {
  const auto most = static_cast<std::uint64_t>(kMax);
  EXPECT_DOUBLE_EQ(DistanceFrom(ExactNumber::Kind::kSigned, -0x1p63)(most), 0x1p64);
  EXPECT_DOUBLE_EQ(DistanceFrom(ExactNumber::Kind::kSigned, 1e19)(most), 0x1p63 - 1e19);
  EXPECT_DOUBLE_EQ(DistanceFrom(ExactNumber::Kind::kSigned, 0.5)(3), 2.5);
}

}  // namespace
}  // namespace tendon::gui
