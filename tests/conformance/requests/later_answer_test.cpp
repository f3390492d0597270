#include <algorithm>
#include <optional>
#include <thread>
#include <utility>

#include "conformance/contract.h"

namespace tendon::conformance {
namespace {

std::optional<std::span<std::byte>> Begin(LeftAnswer& answer, std::uint32_t number) {
  return answer.Begin(*ReadWholeFrame(FrameOf(number)));
}

void Leave(LeftAnswer& answer, std::uint32_t number) {
  const auto room = Begin(answer, number);
  ASSERT_TRUE(room);
  std::ranges::fill(*room, static_cast<std::byte>(number));
  answer.End();
}

TEST_P(LaterAnswerContract, ComesOnceItIsLeftByAnyThreadInAnyOrder) {
  const auto first = Ask();
  const auto second = Ask();

  std::thread([&] { Leave(*second, 2); }).join();
  EXPECT_TRUE(recorder_->WaitForFrames(1));
  std::thread([&] { Leave(*first, 1); }).join();
  EXPECT_TRUE(recorder_->WaitForFrames(2));

  EXPECT_EQ(recorder_->numbers(), (std::vector<std::uint32_t>{2, 1}));
  EXPECT_TRUE(recorder_->intact());
}

TEST_P(LaterAnswerContract, ThatIsDroppedIsNone) {
  Ask().reset();

  Leave(*Ask(), 7);

  EXPECT_TRUE(recorder_->WaitForFrames(1));
  EXPECT_EQ(recorder_->numbers(), std::vector<std::uint32_t>{7});
  EXPECT_EQ(recorder_->closed(), 0);
}

TEST_P(LaterAnswerContract, ThatIsBegunAndNotEndedEndsNothing) {
  {
    const auto answer = Ask();
    EXPECT_TRUE(Begin(*answer, 1));
  }

  Leave(*Ask(), 7);

  EXPECT_TRUE(EventuallyTrue([&] {
    const auto numbers = recorder_->numbers();
    return std::ranges::count(numbers, 7U) == 1;
  }));
  EXPECT_EQ(recorder_->closed(), 0);
}

TEST_P(LaterAnswerContract, DelaysNoEndOfTheLinkThatItsAskerWants) {
  const auto answer = Ask();

  asker_->Close();

  EXPECT_TRUE(recorder_->WaitForClosed());
  EXPECT_TRUE(keeper_->WaitForClosed());
  if (Begin(*answer, 1)) answer->End();  // to nobody
}

TEST_P(LaterAnswerContract, DelaysNoEndOfTheLinkThatWhoIsAskedWants) {
  const auto answer = Ask();

  keeper_->link()->Close();

  EXPECT_TRUE(recorder_->WaitForClosed());
  EXPECT_TRUE(keeper_->WaitForClosed());
}

TEST_P(LaterAnswerContract, DelaysNoEndOfTheListenerAndTheMiddleware) {
  const auto answer = Ask();

  End();

  EXPECT_TRUE(recorder_->WaitForClosed());
  EXPECT_TRUE(keeper_->WaitForClosed());
}

}  // namespace
}  // namespace tendon::conformance
