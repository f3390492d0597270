#include <algorithm>
#include <array>
#include <future>
#include <optional>
#include <span>
#include <vector>

#include "conformance/contract.h"

namespace tendon::conformance {
namespace {

std::optional<std::span<std::byte>> Begin(ReplySlot& reply, std::uint32_t number) {
  return reply.Begin(*ReadWholeFrame(FrameOf(number)));
}

/// Writes the reply to a request. Returns false if the reply came too late, because the machine
/// may stall for half a second.
bool Leave(ReplySlot& reply, std::uint32_t number) {
  const auto room = Begin(reply, number);
  if (!room) return false;
  std::ranges::fill(*room, static_cast<std::byte>(number));
  reply.End();
  return true;
}

TEST_P(LaterReplyContract, MayBeFilledByAnyThreadInAnyOrder) {
  const auto leave = [](ReplySlot& reply, std::uint32_t number) {
    return std::async(std::launch::async, [&] { return Leave(reply, number); }).get();
  };
  EXPECT_TRUE(EventuallyTrue([&] {
    const std::size_t before = recorder_->numbers().size();
    const auto first = Ask();
    const auto second = Ask();
    if (!leave(*second, 2) || !recorder_->WaitForFrames(before + 1)) return false;
    if (!leave(*first, 1) || !recorder_->WaitForFrames(before + 2)) return false;
    const auto numbers = recorder_->numbers();
    return std::ranges::equal(std::span(numbers).last(2), std::array{2U, 1U});
  }));
  EXPECT_TRUE(recorder_->intact());
}

TEST_P(LaterReplyContract, DroppingTheSlotSendsNoReply) {
  Ask().reset();

  EXPECT_TRUE(EventuallyTrue([&] { return Leave(*Ask(), 7); }));

  EXPECT_TRUE(recorder_->WaitForFrames(1));
  EXPECT_EQ(recorder_->numbers(), std::vector<std::uint32_t>{7});
  EXPECT_EQ(recorder_->closed(), 0);
}

TEST_P(LaterReplyContract, AnUnfinishedReplyDoesNotCloseTheLink) {
  EXPECT_TRUE(EventuallyTrue([&] { return Begin(*Ask(), 1).has_value(); }));

  EXPECT_TRUE(EventuallyTrue([&] { return Leave(*Ask(), 7); }));

  EXPECT_TRUE(EventuallyTrue([&] {
    const auto numbers = recorder_->numbers();
    return std::ranges::count(numbers, 7U) == 1;
  }));
  EXPECT_EQ(recorder_->closed(), 0);
}

TEST_P(LaterReplyContract, APendingReplyDoesNotDelayTheOpenersClose) {
  const auto reply = Ask();

  asker_->Close();

  EXPECT_TRUE(recorder_->WaitForClosed());
  EXPECT_TRUE(keeper_->WaitForClosed());
  if (Begin(*reply, 1)) reply->End();  // the caller no longer waits
}

TEST_P(LaterReplyContract, APendingReplyDoesNotDelayTheAcceptorsClose) {
  const auto reply = Ask();

  keeper_->link()->Close();

  EXPECT_TRUE(recorder_->WaitForClosed());
  EXPECT_TRUE(keeper_->WaitForClosed());
}

TEST_P(LaterReplyContract, APendingReplyDoesNotDelayShutdown) {
  const auto reply = Ask();

  End();

  EXPECT_TRUE(recorder_->WaitForClosed());
  EXPECT_TRUE(keeper_->WaitForClosed());
}

}  // namespace
}  // namespace tendon::conformance
