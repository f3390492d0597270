#include <gtest/gtest.h>
#include <support/encoded.h>
#include <tendon/payload/json.h>
#include <tendon/payload/time_point.h>

namespace tendon {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using std::chrono::seconds;
using std::chrono::sys_time;

using test::Encoded;

TEST(TimePoint, EqualsTheTimeOfRos) {
  static_assert(FixedPayload<std::chrono::system_clock::time_point>);
  EXPECT_EQ(SchemaOf<std::chrono::system_clock::time_point>().TypeName(),
            "builtin_interfaces.Time");
  EXPECT_EQ(RosTypeName(SchemaOf<sys_time<seconds>>()), "builtin_interfaces/msg/Time");
  EXPECT_EQ(Encoded(sys_time<milliseconds>(milliseconds(1'500))),
            Encoded(std::array<std::uint32_t, 2>{1, 500'000'000}));
  EXPECT_EQ(ToJson(sys_time<milliseconds>(milliseconds(-500))),
            R"({"sec":-1,"nanosec":500000000})");
}

TEST(TimePoint, RoundTripsInAnyUnit) {
  const sys_time<nanoseconds> sent(nanoseconds(1'700'000'000'123'456'789));
  sys_time<nanoseconds> exact;
  sys_time<milliseconds> rounded;

  ASSERT_TRUE(Decode(Encoded(sent), exact));
  ASSERT_TRUE(Decode(Encoded(sent), rounded));

  EXPECT_EQ(exact, sent);
  EXPECT_EQ(rounded.time_since_epoch(), milliseconds(1'700'000'000'123));
}

TEST(TimePoint, OutOfRangeBecomesTheNearest) {
  sys_time<seconds> time;

  ASSERT_TRUE(Decode(Encoded(sys_time<seconds>(seconds(std::int64_t{1} << 40))), time));

  EXPECT_EQ(time.time_since_epoch(), seconds(0x7fffffff));
}

TEST(TimePoint, ASecondHasLessThanABillionNanoseconds) {
  sys_time<nanoseconds> time;
  EXPECT_FALSE(Decode(Encoded(std::array<std::uint32_t, 2>{1, 1'000'000'000}), time));
}

}  // namespace
}  // namespace tendon
