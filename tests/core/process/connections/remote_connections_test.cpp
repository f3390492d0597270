#include <gmock/gmock.h>

#include <atomic>
#include <thread>

#include "core/process/connections/remote_connection.h"
#include "support/log/log_record.h"

namespace {

using plant::Move;
using plant::Note;
using plant::Operator;
using plant::Plant;
using std::chrono::milliseconds;
using tendon::ConnectionState;
using tendon::ErrorCode;
using tendon::InterfaceName;
using tendon::Process;
using tendon::Status;
using testing::Contains;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

using RemoteConnections = RemoteConnection;

TEST_P(RemoteConnections, CarriesEveryKindOfCommandAndEvent) {
  StartRobot();
  StartDesk();
  Connect();
  const Move move{.number = 7, .goal = {1, 2, 3}};
  const Note note{.text = "a dynamic value", .values = {1.5, 2.5}};

  EXPECT_EQ(user->stop(), Status(Status::kQueued));
  EXPECT_EQ(user->move_to(move), Status(Status::kQueued));
  EXPECT_EQ(user->write(note), Status(Status::kQueued));

  EXPECT_TRUE(EventuallyTrue([&] {
    user->Process();
    return user->stopped == 1 && user->moved.size() == 1 && user->written.size() == 1;
  }));
  EXPECT_EQ(user->moved, std::vector{move});
  EXPECT_EQ(user->written, std::vector{note});
  EXPECT_EQ(plant->moves.values(), std::vector{move});
  EXPECT_EQ(plant->notes.values(), std::vector{note});
  EXPECT_EQ(plant->stops.size(), 1U);

  Move got_move;
  Move scaled;
  Note got_note;
  std::uint64_t result = 0;
  EXPECT_TRUE(EventuallyTrue([&] { return user->get_move(got_move) && got_move == move; }));
  EXPECT_TRUE(EventuallyTrue([&] { return user->get_note(got_note) && got_note == note; }));
  EXPECT_TRUE(EventuallyTrue([&] { return bool(user->get_scaled(2.0, scaled)); }));
  EXPECT_EQ(scaled.goal, (std::array{2.0, 4.0, 6.0}));
  EXPECT_TRUE(EventuallyTrue([&] { return bool(user->ask(result)); }));
  EXPECT_EQ(result, 42U);
}

TEST_P(RemoteConnections, ExecutesEachAcceptedCommandOnceAndInOrderUnderLoad) {
  constexpr std::uint64_t kMoves = 20'000;
  constexpr std::uint64_t kMaxUnderWay = 500;  // their events fit into the operator's mailbox
  StartRobot();
  StartDesk(1024);
  Connect();

  std::uint64_t sent = 0;
  const bool all_arrived = EventuallyTrue(
      [&] {
        while (sent < kMoves && sent - user->moved.size() < kMaxUnderWay &&
               user->move_to({.number = sent})) {
          ++sent;
        }
        user->Process();
        return user->moved.size() >= kMoves;
      },
      std::chrono::seconds(60));

  EXPECT_TRUE(all_arrived) << user->moved.size() << " of " << sent;
  const auto executed = plant->moves.values();
  ASSERT_EQ(executed.size(), kMoves);
  ASSERT_EQ(user->moved.size(), kMoves);
  for (std::uint64_t i = 0; i < kMoves; ++i) {
    ASSERT_EQ(executed[i].number, i);
    ASSERT_EQ(user->moved[i].number, i);
  }
}

TEST_P(RemoteConnections, RefusesCallsBeyondTheServersRoom) {
  StartRobot();
  StartDesk(16);
  Connect();
  std::vector<std::uint64_t> accepted;
  std::uint64_t refused = 0;

  for (std::uint64_t i = 0; accepted.size() < 2000; ++i) {
    if (user->move_to({.number = i})) {
      accepted.push_back(i);
    } else {
      ++refused;
    }
  }

  EXPECT_GT(refused, 0U);
  EXPECT_TRUE(EventuallyTrue([&] { return plant->moves.size() >= accepted.size(); }));
  const auto executed = plant->moves.values();
  ASSERT_EQ(executed.size(), accepted.size());
  for (std::size_t i = 0; i < accepted.size(); ++i) ASSERT_EQ(executed[i].number, accepted[i]);
}

TEST_P(RemoteConnections, ReportsItsCounts) {
  StartDesk(16);
  ASSERT_TRUE(desk->Connect(kRobot, kControl).ok());
  const auto pending = desk->Counts(kRobot);
  ASSERT_FALSE(pending.ok());
  EXPECT_EQ(pending.error().code, ErrorCode::kFailed);
  const auto says = [&](const std::string& regex) {
    return testing::Value(desk->Counts(kRobot).error().message, testing::ContainsRegex(regex));
  };
  EXPECT_TRUE(
      says("desk/operator/Robot is pending for [0-9]+ s: process 'robot' is not available"));
  EXPECT_TRUE(EventuallyTrue([&] { return says("pending for [1-9][0-9]* s: process 'robot'"); }));

  StartRobot();
  ASSERT_TRUE(EventuallyActive(*desk, 1)) << Reason();
  ASSERT_TRUE(EventuallyQueued([&] { return user->stop(); }));

  EXPECT_TRUE(EventuallyTrue([&] { return desk->Counts(kRobot)->taken >= 1; }));
  EXPECT_TRUE(EventuallyTrue([&] { return desk->Counts(kRobot)->round_trip.count() > 0; }));
  EXPECT_GT(desk->Counts(kRobot)->age.count(), 0);
  EXPECT_EQ(desk->Counts(kRobot)->capacity, 16U);
}

TEST_P(RemoteConnections, ReportsThatTheServerDoesNotRun) {
  StartRobot();
  StartDesk();
  Connect();
  ASSERT_EQ(user->stop(), Status(Status::kQueued));

  ASSERT_TRUE(robot->Stop("plant").ok());
  EXPECT_TRUE(EventuallyTrue([&] { return user->stop() == Status(Status::kNotActive); }));

  ASSERT_TRUE(robot->Start("plant").ok());
  EXPECT_TRUE(EventuallyQueued([&] { return user->stop(); }));
}

TEST_P(RemoteConnections, GivesUpAReadAtItsDeadline) {
  StartRobot();
  StartDesk();
  Connect();
  std::uint64_t result = 0;
  ASSERT_TRUE(EventuallyTrue([&] { return bool(user->ask(result)); }));

  std::unique_lock held(plant->gate);
  EXPECT_EQ(user->ask(result), Status(Status::kTimeout));
  held.unlock();

  EXPECT_TRUE(EventuallyTrue([&] { return bool(user->ask(result)); }));
}

TEST_P(RemoteConnections, IsRefusedIfTheInterfacesAreIncompatible) {
  StartRobot();
  StartDesk();
  robot->Add<plant::Impostor>("impostor");

  const auto id = desk->Connect(kRobot, {"robot", "impostor", "Control"});

  ASSERT_FALSE(id.ok());
  EXPECT_EQ(id.error().code, ErrorCode::kIncompatible);
  EXPECT_THAT(id.error().message,
              HasSubstr("desk/operator/Robot does not fit robot/impostor/Control: "));
  EXPECT_THAT(id.error().message, HasSubstr("needs write command 'MoveTo' of plant.Move, but the "
                                            "provider offers another plant.Move"));
  EXPECT_TRUE(desk->connections().empty());
  EXPECT_EQ(user->stop(), Status(Status::kNotConnected));
}

TEST_P(RemoteConnections, RefusesARequiredInterfaceOfAnotherProcess) {
  StartRobot();

  const auto id = robot->Connect(kRobot, kControl);

  ASSERT_FALSE(id.ok());
  EXPECT_EQ(id.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(id.error().message, HasSubstr("is not in process 'robot'"));
}

TEST_P(RemoteConnections, RefusesADuplicate) {
  StartRobot();
  StartDesk();
  desk->Add<Plant>("plant");
  Connect();

  const auto again = desk->Connect(kRobot, kControl);
  const auto here = desk->Connect(kRobot, {"desk", "plant", "Control"});

  ASSERT_FALSE(again.ok());
  EXPECT_EQ(again.error().code, ErrorCode::kExists);
  ASSERT_FALSE(here.ok());
  EXPECT_EQ(here.error().code, ErrorCode::kExists);
}

TEST_P(RemoteConnections, CanBeDisconnectedAndReconnected) {
  StartRobot();
  StartDesk();
  for (int round = 0; round < 3; ++round) {
    Connect();
    ASSERT_EQ(user->stop(), Status(Status::kQueued));

    ASSERT_TRUE(desk->Disconnect(kRobot).ok());

    EXPECT_EQ(user->stop(), Status(Status::kNotConnected));
    EXPECT_TRUE(desk->connections().empty());
    EXPECT_TRUE(desk->proxies().empty());
    EXPECT_TRUE(EventuallyTrue([&] { return robot->proxies().empty(); }));
  }
  EXPECT_TRUE(EventuallyTrue([&] { return plant->stops.size() == 3; }));
  const auto again = desk->Disconnect(kRobot);
  ASSERT_FALSE(again.ok());
  EXPECT_EQ(again.error().code, ErrorCode::kNotFound);
}

TEST_P(RemoteConnections, DisconnectingUnderLoadExecutesOnlyAcceptedCalls) {
  StartRobot();
  StartDesk();
  Connect();
  std::atomic<bool> done = false;
  std::uint64_t accepted = 0;
  std::thread caller([&] {
    while (!done) {
      if (user->move_to({.number = accepted})) ++accepted;
    }
  });
  ASSERT_TRUE(EventuallyTrue([&] { return plant->moves.size() > 200; }));

  ASSERT_TRUE(desk->Disconnect(kRobot).ok());
  done = true;
  caller.join();

  EXPECT_TRUE(EventuallyTrue([&] { return robot->proxies().empty(); }));
  const auto executed = plant->moves.values();
  ASSERT_EQ(executed.size(), accepted);
  for (std::size_t i = 0; i < executed.size(); ++i) ASSERT_EQ(executed[i].number, i);
}

TEST_P(RemoteConnections, AuditsItsOpeningClosingAndCommandCount) {
  const tendon_test::LogRecord audit("audit");
  const std::string kInterface = "): interface robot/plant/Control for desk/operator/Robot: ";
  const std::string kClosed = kInterface + "closed, ";
  StartRobot();
  StartDesk();
  Connect();
  ASSERT_TRUE(EventuallyTrue([&] { return bool(user->move_to({.number = 1})); }));
  ASSERT_TRUE(user->move_to({.number = 2}));
  ASSERT_TRUE(user->stop.Wait(std::chrono::seconds(20)));
  Move position;
  ASSERT_TRUE(EventuallyTrue([&] { return bool(user->get_move(position)); }));
  EXPECT_THAT(audit.texts(), Contains(EndsWith(kInterface + "opened")));
  EXPECT_THAT(audit.texts(), Not(Contains(HasSubstr(kClosed))));

  ASSERT_TRUE(desk->Disconnect(kRobot).ok());

  const auto last = [&] { return audit.texts().empty() ? "" : audit.texts().back(); };
  EXPECT_TRUE(EventuallyTrue([&] { return last().find(kClosed) != std::string::npos; }));
  EXPECT_THAT(last(), StartsWith("desk (operator, "));
  EXPECT_THAT(last(), EndsWith(kClosed + "commands: 3"));
}

TEST_P(RemoteConnections, WaitsForAnAbsentProcess) {
  StartDesk();
  const auto id = desk->Connect(kRobot, kControl);
  ASSERT_TRUE(id.ok()) << id.error().message;
  ASSERT_EQ(desk->connections().size(), 1U);
  EXPECT_EQ(desk->connections().front().state, ConnectionState::kPending);
  EXPECT_THAT(Reason(), HasSubstr("process 'robot' is not available"));
  EXPECT_EQ(user->stop(), Status(Status::kNotConnected));

  StartRobot();

  EXPECT_TRUE(EventuallyActive(*desk, 1)) << Reason();
  EXPECT_EQ(desk->connections().front().id, *id);
  EXPECT_TRUE(EventuallyQueued([&] { return user->stop(); }));
}

TEST_P(RemoteConnections, WaitsForAnAbsentComponent) {
  robot = Start("robot");
  StartDesk();
  const tendon_test::LogRecord audit("audit");
  ASSERT_TRUE(desk->Connect(kRobot, kControl).ok());
  EXPECT_TRUE(EventuallyPending(*desk));
  EXPECT_TRUE(EventuallyTrue([&] { return Reason().find("'plant'") != std::string::npos; }))
      << Reason();
  EXPECT_THAT(audit.texts(), Not(Contains(HasSubstr("plant/Control")))) << "there is none to open";

  robot->Add<Plant>("plant");

  EXPECT_TRUE(EventuallyActive(*desk, 1)) << Reason();
}

TEST_P(RemoteConnections, IsRestoredWhenALostProcessReturns) {
  const tendon_test::LogRecord log("connection");
  StartRobot();
  StartDesk();
  Connect();
  ASSERT_EQ(user->move_to({.number = 1}), Status(Status::kQueued));
  ASSERT_TRUE(EventuallyTrue([&] { return plant->moves.size() == 1; }));

  robot.reset();

  EXPECT_TRUE(EventuallyTrue([&] { return user->stop() == Status(Status::kNotConnected); }));
  EXPECT_TRUE(EventuallyPending(*desk));
  EXPECT_THAT(Reason(), HasSubstr("process 'robot' was lost"));
  Move move;
  EXPECT_EQ(user->get_move(move), Status(Status::kNotConnected));

  StartRobot();
  EXPECT_TRUE(EventuallyActive(*desk, 1)) << Reason();
  EXPECT_TRUE(EventuallyQueued([&] { return user->move_to({.number = 2}); }));
  EXPECT_TRUE(EventuallyTrue([&] { return plant->moves.size() == 1; }));
  EXPECT_EQ(plant->moves.values().front().number, 2U);
  const std::string kEnds = "desk/operator/Robot to robot/plant/Control ";
  const auto lines = log.texts();
  ASSERT_GE(lines.size(), 3U);
  EXPECT_EQ(lines.at(0), kEnds + "is active");
  EXPECT_THAT(lines.at(1), StartsWith(kEnds + "is lost, and will be restored: process 'robot'"));
  EXPECT_EQ(lines.at(2), kEnds + "is active");
}

TEST_P(RemoteConnections, RestoredByTheGcmSatisfiesTheProgramsConnect) {
  StartRobot();
  StartDesk();
  Connect();
  ASSERT_TRUE(EventuallyTrue([&] { return gcm().catalogue().FindConnection(kRobot) != nullptr; }));
  desk.reset();
  StartDesk();
  ASSERT_TRUE(EventuallyActive(*desk, 1)) << "the GCM hands it back";
  const auto handed_back = desk->connections().front().id;

  const auto other = desk->Connect(kRobot, InterfaceName("robot", "other", "Control"));
  const auto asked_for = desk->Connect(kRobot, kControl);
  const auto again = desk->Connect(kRobot, kControl);

  EXPECT_EQ(other.error().code, ErrorCode::kExists);
  ASSERT_TRUE(asked_for.ok()) << asked_for.error().message;
  EXPECT_EQ(*asked_for, handed_back);
  EXPECT_EQ(again.error().code, ErrorCode::kExists) << "that is the program's own";
  EXPECT_EQ(desk->connections().size(), 1U);

  ASSERT_TRUE(desk->Disconnect(kRobot).ok());
  EXPECT_TRUE(desk->connections().empty());
}

TEST_P(RemoteConnections, RestoredWithinAProcessSatisfiesTheProgram) {
  const InterfaceName control("desk", "plant", "Control");
  const auto start = [&] {
    desk = Start("desk");
    desk->Add<Plant>("plant");
    desk->Add<Operator>("operator");
    ASSERT_TRUE(desk->StartAll().ok());
  };
  start();
  ASSERT_TRUE(desk->Connect(kRobot, control).ok());
  ASSERT_TRUE(EventuallyTrue([&] { return gcm().catalogue().FindConnection(kRobot) != nullptr; }));
  desk.reset();
  start();
  ASSERT_TRUE(EventuallyActive(*desk, 1)) << "the GCM hands it back";

  const auto asked_for = desk->Connect(kRobot, control);

  EXPECT_TRUE(asked_for.ok()) << asked_for.error().message;
  EXPECT_EQ(desk->Connect(kRobot, control).error().code, ErrorCode::kExists);
}

TEST_P(RemoteConnections, IsRestoredWhenARemovedComponentReturns) {
  StartRobot();
  StartDesk();
  Connect();

  ASSERT_TRUE(robot->Remove("plant").ok());

  EXPECT_TRUE(EventuallyPending(*desk));
  EXPECT_TRUE(robot->proxies().empty());
  EXPECT_EQ(user->stop(), Status(Status::kNotConnected));

  plant = &robot->Add<Plant>("plant");
  ASSERT_TRUE(robot->StartAll().ok());
  EXPECT_TRUE(EventuallyActive(*desk, 1)) << Reason();
  EXPECT_TRUE(EventuallyQueued([&] { return user->stop(); }));
}

TEST_P(RemoteConnections, EndsWithItsOwnComponent) {
  StartRobot();
  StartDesk();
  Connect();

  ASSERT_TRUE(desk->Remove("operator").ok());

  EXPECT_TRUE(desk->connections().empty());
  EXPECT_TRUE(desk->proxies().empty());
  EXPECT_TRUE(EventuallyTrue([&] { return robot->proxies().empty(); }));
}

TEST_P(RemoteConnections, WorksInBothDirectionsAtOnce) {
  StartRobot();
  StartDesk();
  auto& other_user = robot->Add<Operator>("operator");
  desk->Add<Plant>("plant");
  ASSERT_TRUE(robot->StartAll().ok());
  ASSERT_TRUE(desk->StartAll().ok());

  tendon::Result<tendon::ConnectionId> back = 0;
  std::thread other([&] {
    back = robot->Connect({"robot", "operator", "Robot"}, {"desk", "plant", "Control"});
  });
  const auto forth = desk->Connect(kRobot, kControl);
  other.join();

  ASSERT_TRUE(forth.ok() && back.ok());
  EXPECT_TRUE(EventuallyActive(*desk, 1));
  EXPECT_TRUE(EventuallyActive(*robot, 1));
  EXPECT_TRUE(EventuallyQueued([&] { return other_user.stop(); }));
}

INSTANTIATE_TEST_SUITE_P(Over, RemoteConnections, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

}  // namespace
