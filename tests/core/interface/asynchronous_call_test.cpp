#include <gtest/gtest.h>

#include "core/interface/waiting_fixture.h"

namespace {

using namespace std::chrono_literals;
using tendon::Status;
using tendon_test::Planner;

/// Asynchronous calls of a planner's commands: no thread waits for them. The test executes the
/// commands.
class AsynchronousCall : public testing::Test {
 protected:
  tendon::CommandBase* Bind(const std::string& name) {
    const tendon::Offer* offer = planner.plans.FindCommand(name);
    mailbox = &planner.inbox.Open(2, offer->shape());
    bound = offer->Bind(mailbox);
    return bound.get();
  }
  ~AsynchronousCall() override {
    if (mailbox != nullptr) planner.inbox.Remove(*mailbox);
  }

  template <typename In>
  Status Begin(tendon::CommandBase& command, const In& argument) {
    std::vector<std::byte> in;
    tendon::Encode(argument, in);
    return command.BeginEncoded(in, out, ended, call);
  }

  Planner planner;
  tendon::Mailbox* mailbox = nullptr;
  std::unique_ptr<tendon::CommandBase> bound;  // must exist as long as its calls are in the mailbox
  tendon::Wakeup<> ended;
  std::size_t call = 0;
  std::vector<std::byte> out;
};

TEST_F(AsynchronousCall, EndsAfterItsExecution) {
  planner.moves = {1, 2};
  auto* const describe = Bind("Describe");
  ASSERT_EQ(Begin(*describe, std::string("moves: ")), Status(Status::kQueued));
  EXPECT_FALSE(describe->HasEnded(call));

  planner.inbox.ExecuteQueued();

  ASSERT_TRUE(describe->HasEnded(call));
  EXPECT_EQ(describe->EndEncoded(call, out), Status(Status::kDone));
  tendon_test::Message message;
  ASSERT_TRUE(tendon::Decode(out, message));
  EXPECT_EQ(message.text, "moves: 2");
}

TEST_F(AsynchronousCall, NotifiesItsListener) {
  auto* const move = Bind("Move");
  ASSERT_EQ(Begin(*move, std::int32_t{5}), Status(Status::kQueued));
  const tendon_test::Executor executor(planner.inbox);

  const bool was_told =
      ended.WaitUntil([&] { return move->HasEnded(call); }, std::chrono::steady_clock::now() + 20s);

  EXPECT_TRUE(was_told);
  EXPECT_EQ(move->EndEncoded(call, out), Status(Status::kDone));
}

TEST_F(AsynchronousCall, IsNotExecutedIfEndedBefore) {
  auto* const move = Bind("Move");
  ASSERT_EQ(Begin(*move, std::int32_t{5}), Status(Status::kQueued));

  EXPECT_EQ(move->EndEncoded(call, out), Status(Status::kTimeout));

  planner.inbox.ExecuteQueued();
  EXPECT_TRUE(planner.moves.empty());
}

TEST_F(AsynchronousCall, EndsWhenTheServerStops) {
  auto* const move = Bind("Move");
  ASSERT_EQ(Begin(*move, std::int32_t{5}), Status(Status::kQueued));

  planner.inbox.SetAccepting(false);

  EXPECT_TRUE(move->HasEnded(call));
  EXPECT_EQ(move->EndEncoded(call, out), Status(Status::kNotActive));
}

TEST_F(AsynchronousCall, IsRefusedWhenTheMailboxIsFull) {
  auto* const move = Bind("Move");
  ASSERT_EQ(Begin(*move, std::int32_t{1}), Status(Status::kQueued));
  const std::size_t first = call;
  ASSERT_EQ(Begin(*move, std::int32_t{2}), Status(Status::kQueued));

  EXPECT_EQ(Begin(*move, std::int32_t{3}), Status(Status::kQueueFull));

  planner.inbox.ExecuteQueued();
  EXPECT_EQ(move->EndEncoded(first, out), Status(Status::kDone));
  EXPECT_EQ(move->EndEncoded(call, out), Status(Status::kDone));
  EXPECT_EQ(planner.moves, (std::vector<std::int32_t>{1, 2}));
}

TEST_F(AsynchronousCall, IsExecutedAtOnceWithoutAThread) {
  const auto move = planner.plans.FindCommand("Move")->Bind(nullptr);

  EXPECT_EQ(Begin(*move, std::int32_t{5}), Status(Status::kDone));

  EXPECT_EQ(planner.moves, (std::vector<std::int32_t>{5}));
}

}  // namespace
