#include <gmock/gmock.h>
#include <tendon/middleware/loopback.h>
#include <tendon/process/viewer_messages.h>
#include <tendon/state/state_table.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <string>

#include "core/process/connections/remote_connection.h"
#include "support/allocation_guard.h"

namespace {

using namespace std::chrono_literals;
using plant::Move;
using plant::Note;
using tendon::Status;
using tendon::SteadyClock;
using tendon::SteadyTime;
using testing::HasSubstr;

const tendon::InterfaceName kGauge("robot", "gauge", "Level");
const tendon::InterfaceName kReader("desk", "reader", "Level");

/// A component without a thread: the test writes its rows.
class Gauge final : public tendon::Component {
 public:
  explicit Gauge(std::string name) : Component(std::move(name)) {
    table_.Add(move_, "Move");
    table_.Add(note_, "Note", 64);
    auto& level = AddProvidedInterface("Level");
    get_move = &level.AddCommandReadState(table_, move_, "GetMove");
    level.AddCommandReadState(table_, note_, "GetNote");
    level.AddCommandReadState(table_, move_, "GetMoveBefore", 1);
  }

  /// Writes a row, and returns its time.
  SteadyTime Write(std::uint64_t number, const std::string& text) {
    move_ = {.number = number, .goal = {1, 2, 3}};
    note_.text = text;
    const SteadyTime now = SteadyClock().Now();
    table_.Advance(now);
    return now;
  }

  tendon::Offer* get_move = nullptr;

 private:
  tendon::StateTable table_;
  Move move_;
  Note note_;
};

/// A component without a thread: the test reads with its functions. The read values are mirrored.
class Reader final : public tendon::Component {
 public:
  explicit Reader(std::string name, const std::string& move = "GetMove")
      : Component(std::move(name)) {
    auto& level = AddRequiredInterface("Level");
    level.AddFunction(get_move, move);
    level.AddFunction(get_note, "GetNote");
    level.AddFunction(get_nothing, "GetNothing", tendon::Need::kOptional);
    level.Mirror(get_move);
    level.Mirror(get_note);
    level.Mirror(get_nothing);
  }

  tendon::ReadFunction<Move> get_move;
  tendon::ReadFunction<Note> get_note;
  tendon::ReadFunction<Move> get_nothing;
};

/// Process robot with a gauge, process desk with a reader.
class MirroredRead : public NetworkTest {
 protected:
  MirroredRead() {
    StartRobot();
    desk = Start("desk");
    reader = &desk->Add<Reader>("reader");
    EXPECT_TRUE(desk->StartAll().ok());
  }

  void StartRobot() {
    robot = Start("robot");
    gauge = &robot->Add<Gauge>("gauge");
    EXPECT_TRUE(robot->StartAll().ok());
  }
  void Connect() {
    const auto id = desk->Connect(kReader, kGauge);
    ASSERT_TRUE(id.ok()) << id.error().message;
    ASSERT_TRUE(EventuallyActive(*desk, 1)) << desk->connections().front().reason;
  }
  [[nodiscard]] bool EventuallyReads(std::uint64_t number) const {
    return EventuallyTrue([&] {
      Move move;
      return reader->get_move(move) && move.number == number;
    });
  }

  std::unique_ptr<tendon::Process> robot;
  std::unique_ptr<tendon::Process> desk;
  Gauge* gauge = nullptr;
  Reader* reader = nullptr;
};

TEST_P(MirroredRead, HasNoSampleBeforeTheFirstRow) {
  Connect();
  Move move;

  EXPECT_EQ(reader->get_move(move), Status(Status::kNoSample));
  EXPECT_EQ(reader->get_move.age(), std::chrono::nanoseconds::max());
  EXPECT_EQ(reader->get_nothing(move), Status(Status::kNotConnected));
}

TEST_P(MirroredRead, AnswersWithARowWrittenBeforeConnecting) {
  gauge->Write(7, "before");
  Connect();
  Move move;
  Note note;

  EXPECT_EQ(reader->get_move(move), Status(Status::kDone));
  EXPECT_EQ(reader->get_note(note), Status(Status::kDone));
  EXPECT_EQ(move, (Move{.number = 7, .goal = {1, 2, 3}}));
  EXPECT_EQ(note.text, "before");
}

TEST_P(MirroredRead, FollowsTheTable) {
  Connect();
  for (std::uint64_t number = 1; number <= 10; ++number) {
    gauge->Write(number, std::string(number, 'x'));

    ASSERT_TRUE(EventuallyReads(number));
    ASSERT_TRUE(EventuallyTrue([&] {
      Note note;
      return reader->get_note(note) && note.text == std::string(number, 'x');
    }));
  }
}

TEST_P(MirroredRead, ReportsTheAgeOfItsValue) {
  Connect();
  const SteadyTime written = gauge->Write(1, "");
  ASSERT_TRUE(EventuallyReads(1));

  const SteadyTime before = SteadyClock().Now();
  const auto age = reader->get_move.age();
  const SteadyTime after = SteadyClock().Now();

  EXPECT_GE(age, before - written);
  EXPECT_LE(age, after - written);
}

TEST_P(MirroredRead, HasNoSampleIfTheValueExceedsItsColumn) {
  gauge->Write(1, "short");
  Connect();
  Note note;
  ASSERT_EQ(reader->get_note(note), Status(Status::kDone));

  gauge->Write(2, std::string(100, 'x'));

  EXPECT_TRUE(EventuallyTrue([&] { return reader->get_note(note) == Status(Status::kNoSample); }));
  EXPECT_TRUE(EventuallyReads(2));
}

TEST_P(MirroredRead, AllocatesNothingAfterTheFirstAnswer) {
  gauge->Write(1, "note");
  Connect();
  Move move;
  ASSERT_EQ(reader->get_move(move), Status(Status::kDone));

  const tendon::AllocationGuard guard;
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(reader->get_move(move), Status(Status::kDone));
}

TEST_P(MirroredRead, FailsWhileTheProcessIsLostAndThenResumes) {
  gauge->Write(1, "");
  Connect();
  ASSERT_TRUE(EventuallyReads(1));

  robot.reset();
  Move move;
  EXPECT_TRUE(
      EventuallyTrue([&] { return reader->get_move(move) == Status(Status::kNotConnected); }));
  EXPECT_EQ(reader->get_move.age(), std::chrono::nanoseconds::max());

  StartRobot();
  gauge->Write(2, "");
  EXPECT_TRUE(EventuallyReads(2));
}

TEST_P(MirroredRead, FailsOnceTheComponentIsRemoved) {
  gauge->Write(1, "");
  Connect();
  ASSERT_TRUE(EventuallyReads(1));

  ASSERT_TRUE(robot->Remove("gauge").ok());

  Move move;
  EXPECT_TRUE(
      EventuallyTrue([&] { return reader->get_move(move) == Status(Status::kNotConnected); }));
}

TEST_P(MirroredRead, RefusesCommandsThatDoNotReadTheNewestRow) {
  desk->Add<Reader>("wishful", "GetMoveBefore");

  const auto id = desk->Connect({"desk", "wishful", "Level"}, kGauge);

  ASSERT_FALSE(id.ok());
  EXPECT_EQ(id.error().code, tendon::ErrorCode::kIncompatible);
  EXPECT_THAT(id.error().message, HasSubstr("'GetMoveBefore' of robot/gauge/Level cannot be "
                                            "mirrored"));
}

TEST_P(MirroredRead, FailsWhileTheCommandIsDisabled) {
  gauge->Write(1, "note");
  Connect();
  Move move;
  Note note;
  ASSERT_EQ(reader->get_move(move), Status(Status::kDone));

  gauge->get_move->Disable();

  EXPECT_TRUE(EventuallyTrue([&] { return reader->get_move(move) == Status(Status::kDisabled); }));
  EXPECT_EQ(reader->get_note(note), Status(Status::kDone)) << "another command";
  gauge->Write(2, "note");
  gauge->get_move->Enable();
  EXPECT_TRUE(EventuallyReads(2));
}

TEST_P(MirroredRead, FailsIfTheCommandWasDisabledBefore) {
  gauge->Write(1, "");
  gauge->get_move->Disable();
  Connect();
  Move move;

  EXPECT_EQ(reader->get_move(move), Status(Status::kDisabled));
}

TEST_P(MirroredRead, InOneProcessReadsTheRowItself) {
  auto& here = robot->Add<Reader>("reader", "GetMoveBefore");
  ASSERT_TRUE(robot->StartAll().ok());
  ASSERT_TRUE(robot->Connect({"robot", "reader", "Level"}, kGauge).ok());
  gauge->Write(1, "");
  gauge->Write(2, "");
  Move move;

  EXPECT_EQ(here.get_move(move), Status(Status::kDone));
  EXPECT_EQ(move.number, 1U);
  EXPECT_EQ(here.get_move.age(), 0ns);
}

INSTANTIATE_TEST_SUITE_P(Over, MirroredRead, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

std::atomic<int> ended{0};

/// A loopback network that counts the ended subscriptions.
NetworkKind CountingLoopback() {
  return {.name = "loopback", .make = [] {
            const auto network = std::make_shared<tendon::LoopbackNetwork>();
            network->SetFaultInjector([](const tendon::loopback::Frame& frame) {
              const auto header = tendon::ReadFrameHeader(frame.bytes);
              if (header && header->type == tendon::message::kUnsubscribe) ++ended;
              return tendon::loopback::kPass;
            });
            return [network] { return std::make_shared<tendon::LoopbackMiddleware>(network); };
          }};
}

using EndedMirror = MirroredRead;

TEST_P(EndedMirror, StopsEvenIfNoRowIsWritten) {
  Connect();
  ASSERT_TRUE(desk->Disconnect(kReader).ok());
  ASSERT_TRUE(EventuallyTrue([&] { return desk->connections().empty(); }));
  ended = 0;

  Connect();

  EXPECT_TRUE(EventuallyTrue([] { return ended == 2; })) << "GetMove and GetNote";
}

INSTANTIATE_TEST_SUITE_P(Counted, EndedMirror, testing::Values(CountingLoopback()), NameOfNetwork);

}  // namespace
