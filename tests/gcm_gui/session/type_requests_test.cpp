#include <gcm_gui/session/type_requests.h>
#include <gtest/gtest.h>

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using Due = std::vector<std::pair<Fingerprint, std::string>>;

constexpr Fingerprint kType{1, 2};
const Error kNoReply{ErrorCode::kTimeout, "no reply"};

TEST(TypeRequests, RequestsEachTypeOnce) {
  TypeRequests types;
  types.want(kType, "robot");

  EXPECT_EQ(types.takeDue(SteadyTime()), (Due{{kType, "robot"}}));
  EXPECT_TRUE(types.takeDue(SteadyTime(1h)).empty());
  EXPECT_EQ(types.find(kType), nullptr);
  types.onReply(kType, SchemaOf<double>(), SteadyTime(1h));
  types.want(kType, "desk");

  EXPECT_TRUE(types.takeDue(SteadyTime(2h)).empty());
  ASSERT_NE(types.find(kType), nullptr);
  EXPECT_TRUE(types.find(kType)->ok());
}

TEST(TypeRequests, RetriesAFailedRequestWithBackoff) {
  TypeRequests types;
  types.want(kType, "robot");
  SteadyTime now{};
  (void)types.takeDue(now);
  types.onReply(kType, kNoReply, now);
  EXPECT_EQ(types.find(kType)->error().message, "no reply");

  for (const std::chrono::seconds pause : {1s, 2s, 4s, 8s, 16s, 30s, 30s}) {
    EXPECT_TRUE(types.takeDue(now + pause - 1ns).empty());
    now += pause;
    EXPECT_EQ(types.takeDue(now), (Due{{kType, "robot"}}));
    types.onReply(kType, kNoReply, now);
  }

  types.want(kType, "desk");
  EXPECT_EQ(types.takeDue(now + 1min), (Due{{kType, "desk"}}));
  types.onReply(kType, SchemaOf<double>(), now);
  EXPECT_TRUE(types.find(kType)->ok());
}

}  // namespace
}  // namespace tendon::gui
