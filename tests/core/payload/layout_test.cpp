#include <gtest/gtest.h>
#include <tendon/payload/eigen.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/payload/layout.h>
#include <tests/core/payload/sample_types.h>

namespace tendon {
namespace {

using std::chrono::duration;
using std::chrono::milliseconds;
using std::chrono::nanoseconds;

/// The two types have the same fingerprint but another layout, so a pointer to one must not be used
/// for the other.
template <typename A, typename B>
void ExpectAnotherLayout() {
  EXPECT_EQ(FingerprintOf<A>(), FingerprintOf<B>());
  EXPECT_NE(LayoutOf<A>(), LayoutOf<B>());
}

TEST(Layout, DiffersIfEqualBytesMeanAnotherValue) {
  ExpectAnotherLayout<milliseconds, nanoseconds>();
  ExpectAnotherLayout<nanoseconds, duration<double>>();
  ExpectAnotherLayout<std::vector<milliseconds>, std::vector<nanoseconds>>();
  ExpectAnotherLayout<Eigen::Matrix3d, Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>();
  ExpectAnotherLayout<Eigen::Matrix3d, std::array<std::array<double, 3>, 3>>();
}

struct Reordered {
  std::array<double, 7> velocity{};
  std::array<double, 7> position{};
};

TEST(Layout, DiffersFromThatOfAProxy) {
  EXPECT_NE(LayoutOf<None>(), layout::kNone);
  EXPECT_EQ(LayoutOf<sample::Dynamic>(), LayoutOf<sample::Dynamic>());
}

}  // namespace
}  // namespace tendon

template <>
inline constexpr auto tendon::kPayload<tendon::Reordered> = tendon::Describe(
    "sample.JointState", tendon::Field{"position", &tendon::Reordered::position, "rad"},
    tendon::Field{"velocity", &tendon::Reordered::velocity, "rad/s"});

namespace tendon {
namespace {

TEST(Layout, DiffersWithTheOffsetsOfFields) {
  ExpectAnotherLayout<Reordered, sample::JointState>();
}

}  // namespace
}  // namespace tendon
