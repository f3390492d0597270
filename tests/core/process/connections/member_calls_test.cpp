#include <gmock/gmock.h>
#include <tendon/base/os/process.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/viewer_messages.h>

#include <atomic>
#include <mutex>

#include "support/network_test.h"
#include "support/plant.h"

namespace {

using plant::Move;
using plant::Plant;
using tendon::EncodeBody;
using tendon::ErrorCode;
using tendon::Status;
using tendon::message::CallMember;
using tendon::message::CallMemberReply;
using tendon::message::GetSchemas;
using tendon::message::Schemas;
using testing::HasSubstr;

/// A console that has opened a channel to a process.
class MemberCall : public NetworkTest {
 protected:
  MemberCall() {
    robot = Start("robot");
    plant = &robot->Add<Plant>("plant");
    EXPECT_TRUE(robot->StartAll().ok());
    const tendon::Hello hello{.instance = tendon::os::RandomNumber(),
                              .name = "console",
                              .cookie = *tendon::LoopbackCookie()};
    auto opened =
        tendon::Channel::Open(*middleware, robot->address(), hello,
                              std::make_shared<tendon::ChannelHandler>(), std::chrono::seconds(20));
    EXPECT_TRUE(opened.ok()) << opened.error().message;
    channel = *opened;
  }
  ~MemberCall() override { channel->Close(); }

  tendon::Result<CallMemberReply> Call(const std::string& interface, const std::string& member,
                                       tendon::Bytes argument = {}) {
    return channel->Call<CallMemberReply>(
        tendon::message::kCallMember, 0,
        CallMember{"plant", interface, member, std::move(argument)}, std::chrono::seconds(20));
  }
  Status StatusOf(const tendon::Result<CallMemberReply>& called) {
    return static_cast<Status::Code>(called->status);
  }

  std::unique_ptr<tendon::Process> robot;
  Plant* plant = nullptr;
  std::shared_ptr<tendon::Middleware> middleware = NewMiddleware();
  std::shared_ptr<tendon::Channel> channel;
};

TEST_P(MemberCall, ExecutesCommandsOfEveryKindByName) {
  const Move move{.number = 3, .goal = {1, 2, 3}};

  const auto stopped = Call("Control", "Stop");
  const auto moved = Call("Control", "MoveTo", EncodeBody(move));

  ASSERT_TRUE(stopped.ok()) << stopped.error().message;
  EXPECT_EQ(StatusOf(stopped), Status(Status::kQueued));
  EXPECT_EQ(StatusOf(moved), Status(Status::kQueued));
  EXPECT_TRUE(EventuallyTrue([&] { return plant->stops.size() == 1; }));
  EXPECT_TRUE(EventuallyTrue([&] { return plant->moves.size() == 1; }));
  EXPECT_EQ(plant->moves.values(), std::vector{move});

  Move read;
  EXPECT_TRUE(EventuallyTrue([&] {
    const auto called = Call("Control", "GetMove");
    return called && tendon::Decode(called->result, read) && read == move;
  }));
  const auto scaled = Call("Control", "GetScaled", EncodeBody(3.0));
  ASSERT_TRUE(tendon::Decode(scaled->result, read));
  EXPECT_EQ(read.goal, (std::array{3.0, 6.0, 9.0}));
  const auto column = Call("state", "Move");
  ASSERT_TRUE(tendon::Decode(column->result, read));
  EXPECT_EQ(read, move);
}

TEST_P(MemberCall, ReturnsTheStatusOfAnUnexecutedCall) {
  EXPECT_EQ(StatusOf(Call("Control", "MoveTo", {std::byte{1}})), Status(Status::kInvalid));
  ASSERT_TRUE(robot->Stop("plant").ok());
  EXPECT_EQ(StatusOf(Call("Control", "Stop")), Status(Status::kNotActive));
}

TEST_P(MemberCall, OfAHungMethodDoesNotBlockOthers) {
  constexpr int kMax = 64;
  std::unique_lock closed(plant->gate);
  std::atomic<int> answered = 0;
  std::atomic<int> refused = 0;
  const auto ask = [&] {
    channel->Request<CallMemberReply>(
        tendon::message::kCallMember, 0, CallMember{"plant", "Control", "Ask", {}},
        std::chrono::seconds(60),
        [&](const tendon::Result<CallMemberReply>& called) { ++(called ? answered : refused); });
  };
  ask();
  ASSERT_TRUE(EventuallyTrue([&] { return plant->asked == 1; }));

  for (int i = 0; i < kMax; ++i) ask();

  EXPECT_TRUE(EventuallyTrue([&] { return refused == 1; })) << "as many wait as may";
  EXPECT_TRUE(EventuallyTrue(
      [&] { return StatusOf(Call("Control", "GetMove")) == Status(Status::kDone); }));
  EXPECT_EQ(StatusOf(Call("Control", "Stop")), Status(Status::kQueued));
  EXPECT_EQ(answered, 0);

  closed.unlock();
  EXPECT_TRUE(EventuallyTrue([&] { return answered == kMax; }));
  EXPECT_EQ(refused, 1);
}

TEST_P(MemberCall, OfAnUnknownMemberIsRefusedWithASuggestion) {
  const auto no_member = Call("Control", "Stopp");
  const auto no_interface = Call("Kontrol", "Stop");

  ASSERT_FALSE(no_member.ok());
  EXPECT_EQ(no_member.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(no_member.error().message,
              HasSubstr("robot/plant/Control has no command 'Stopp'; did you mean 'Stop'?"));
  ASSERT_FALSE(no_interface.ok());
  EXPECT_THAT(no_interface.error().message, HasSubstr("did you mean 'Control'?"));
}

TEST_P(MemberCall, ForgetsARemovedComponent) {
  ASSERT_TRUE(Call("Control", "Stop").ok());
  ASSERT_TRUE(Call("Control", "Ask").ok());

  ASSERT_TRUE(robot->Remove("plant").ok());

  const auto called = Call("Control", "Stop");
  ASSERT_FALSE(called.ok());
  EXPECT_EQ(called.error().code, ErrorCode::kNotFound);
  EXPECT_FALSE(Call("Control", "Ask").ok());
}

TEST_P(MemberCall, FindsTheSchemaOfEveryPayload) {
  const GetSchemas wanted{
      {tendon::FingerprintOf<Move>(), {1, 2}, tendon::FingerprintOf<tendon::CycleStatistics>()}};

  const auto schemas =
      channel->Call<Schemas>(tendon::message::kGetSchemas, 0, wanted, std::chrono::seconds(20));

  ASSERT_TRUE(schemas.ok()) << schemas.error().message;
  ASSERT_EQ(schemas->texts.size(), 3U);
  EXPECT_EQ(schemas->texts[0], tendon::SchemaOf<Move>().Text());
  EXPECT_EQ(schemas->texts[1], "");
  EXPECT_EQ(schemas->texts[2], tendon::SchemaOf<tendon::CycleStatistics>().Text());
}

TEST_P(MemberCall, UnknownAndMalformedMessagesAreRefused) {
  const auto answer = channel->Call(static_cast<tendon::MessageType>(0x7777), 0, tendon::Bytes(),
                                    std::chrono::seconds(20));
  const auto malformed =
      channel->Call(tendon::message::kCallMember, 0, tendon::Bytes(3), std::chrono::seconds(20));

  EXPECT_FALSE(answer.ok());
  ASSERT_FALSE(malformed.ok());
  EXPECT_EQ(malformed.error().code, ErrorCode::kInvalid);
  EXPECT_TRUE(Call("Control", "Stop").ok());
}

INSTANTIATE_TEST_SUITE_P(Over, MemberCall, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

}  // namespace
