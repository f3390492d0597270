#include <gtest/gtest.h>
#include <tendon/manager/local_manager.h>

#include "support/network_test.h"
#include "support/plant.h"

/// Tests the main claim of the framework: components do not know in which process their peers are.
namespace {

using plant::Move;
using plant::Note;
using plant::Operator;
using plant::Plant;
using tendon::LocalManager;

/// The calls and events of the two components, in whichever processes they are.
struct Outcome {
  std::vector<Move> moves;
  std::vector<Note> notes;
  std::vector<Move> moved;
  std::vector<Note> written;
  std::size_t stops = 0;
  int stopped = 0;
  Move read;
  Move scaled;
  std::uint64_t answer = 0;

  bool operator==(const Outcome&) const = default;
};

Outcome Work(Plant& plant, Operator& user) {
  Outcome outcome;
  for (std::uint64_t i = 1; i <= 20; ++i) {
    const double value = static_cast<double>(i);
    EXPECT_TRUE(EventuallyTrue([&] { return bool(user.move_to({i, {value, -value, 0}})); }));
    EXPECT_TRUE(EventuallyTrue([&] { return bool(user.write({std::string(i, 'n'), {value}})); }));
  }
  EXPECT_TRUE(EventuallyTrue([&] { return bool(user.stop()); }));
  EXPECT_TRUE(EventuallyTrue([&] {
    user.Process();
    return user.stopped == 1;
  }));
  EXPECT_TRUE(
      EventuallyTrue([&] { return user.get_move(outcome.read) && outcome.read.number == 20; }));
  EXPECT_TRUE(EventuallyTrue([&] { return bool(user.get_scaled(0.5, outcome.scaled)); }));
  EXPECT_TRUE(EventuallyTrue([&] { return bool(user.ask(outcome.answer)); }));
  outcome.moves = plant.moves.values();
  outcome.notes = plant.notes.values();
  outcome.stops = plant.stops.size();
  outcome.moved = user.moved;
  outcome.written = user.written;
  outcome.stopped = user.stopped;
  return outcome;
}

Outcome WorkInOneProcess() {
  LocalManager manager;
  auto& plant = manager.Add<Plant>("plant");
  auto& user = manager.Add<Operator>("operator");
  EXPECT_TRUE(manager.Connect({"operator", "Robot"}, {"plant", "Control"}).ok());
  EXPECT_TRUE(manager.StartAll().ok());
  return Work(plant, user);
}

class SameComponents : public NetworkTest {};

TEST_P(SameComponents, BehaveAlikeInOneProcessAndInTwo) {
  const Outcome in_one = WorkInOneProcess();

  const auto robot = Start("robot");
  const auto desk = Start("desk");
  auto& plant = robot->Add<Plant>("plant");
  auto& user = desk->Add<Operator>("operator");
  ASSERT_TRUE(desk->Connect({"desk", "operator", "Robot"}, {"robot", "plant", "Control"}).ok());
  ASSERT_TRUE(robot->StartAll().ok());
  ASSERT_TRUE(desk->StartAll().ok());
  const Outcome in_two = Work(plant, user);

  EXPECT_EQ(in_one.moves.size(), 20U);
  EXPECT_EQ(in_one.moved, in_one.moves);
  EXPECT_EQ(in_two, in_one);
}

INSTANTIATE_TEST_SUITE_P(Over, SameComponents, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

}  // namespace
