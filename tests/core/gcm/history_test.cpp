#include <gtest/gtest.h>
#include <tendon/gcm/history.h>
#include <tests/core/gcm/folder.h>

namespace tendon {
namespace {

message::HistoryEntry Step(int number) {
  const std::string interface = "Robot" + std::to_string(number);
  return {.verb = number % 2 == 0 ? "connect" : "disconnect",
          .wire = {{"desk", "teleoperation", interface}, {"robot", "arm", "Control"}},
          .who = "gcm \"connect\"\n",
          .when = 1'700'000'000'000'000'000 + number};
}

TEST(History, KnowsItsStepsAfterARestart) {
  const test::Folder folder;
  const auto file = folder.path() / "history.jsonl";
  std::vector<message::HistoryEntry> steps;
  {
    History history(file);
    for (int i = 0; i < 60; ++i) {
      steps.push_back(Step(i));
      ASSERT_TRUE(history.Record(steps.back()));
    }
    steps[59].undone = true;
    ASSERT_TRUE(history.MarkUndone(steps[59].id));
  }

  const History again(file);

  EXPECT_EQ(again.steps().entries, steps);
  EXPECT_EQ(again.last(), steps[58]);
}

TEST(History, ALastLineCutShortAnywhereIsLeftOut) {
  const test::Folder folder;
  const auto file = folder.path() / "history.jsonl";
  auto first = Step(0);
  auto second = Step(1);
  History history(file);
  ASSERT_TRUE(history.Record(first));
  const std::string one = folder.Read("history.jsonl");
  ASSERT_TRUE(history.Record(second));
  const std::string two = folder.Read("history.jsonl");
  for (std::size_t size = one.size(); size < two.size(); ++size) {
    folder.Write("history.jsonl", two.substr(0, size));

    History torn(file);
    auto third = Step(2);
    ASSERT_TRUE(torn.Record(third));

    EXPECT_EQ(torn.steps().entries, (std::vector{first, third})) << size;
    EXPECT_EQ(History(file).steps().entries, (std::vector{first, third})) << size;
  }
}

TEST(History, ALineThatDoesNotReadIsLeftOutAlone) {
  const test::Folder folder;
  auto first = Step(0);
  auto second = Step(1);
  {
    History history(folder.path() / "h");
    ASSERT_TRUE(history.Record(first));
    ASSERT_TRUE(history.Record(second));
  }
  const std::string text = folder.Read("h");
  const std::size_t end = text.find('\n') + 1;
  for (const std::string bad : {"", "nonsense", "[]", "{\"id\":7}", "{\"undo\":\"x\"}", "17",
                                "{\"id\":1,\"verb\":\"connect\",\"required\":\"a\","
                                "\"provided\":\"b\",\"who\":\"x\",\"when\":1}"}) {
    folder.Write("h", text.substr(0, end) + bad + "\n" + text.substr(end));
    EXPECT_EQ(History(folder.path() / "h").steps().entries, (std::vector{first, second})) << bad;
  }
}

TEST(History, AMissingFileIsAnEmptyHistory) {
  const test::Folder folder;
  const History history(folder.path() / "none");
  EXPECT_TRUE(history.steps().entries.empty());
  EXPECT_FALSE(history.last());
}

TEST(History, KeepsTheNewestStepsWhenThereAreTooMany) {
  const test::Folder folder;
  std::string text;
  {
    History history(folder.path() / "h");
    auto step = Step(0);
    ASSERT_TRUE(history.Record(step));
    text = folder.Read("h");
  }
  std::string many;
  for (std::size_t i = 0; i < History::kMaxSteps + 10; ++i) {
    std::string line = text;
    many += line.replace(line.find("1"), 1, std::to_string(i + 1));
  }
  folder.Write("h", many);

  const auto steps = History(folder.path() / "h").steps().entries;

  ASSERT_EQ(steps.size(), History::kMaxSteps);
  EXPECT_EQ(steps.front().id, 11U);
  EXPECT_LT(folder.Read("h").size(), many.size());
}

TEST(History, WhatCannotBeWrittenIsSaidAndStillKnown) {
  History history("/proc/nowhere/history");
  auto step = Step(0);

  const auto written = history.Record(step);

  ASSERT_FALSE(written);
  EXPECT_NE(written.error().message.find("/proc/nowhere/history"), std::string::npos);
  EXPECT_EQ(history.last(), step);
}

}  // namespace
}  // namespace tendon
