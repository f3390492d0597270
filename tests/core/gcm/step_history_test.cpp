#include <gtest/gtest.h>
#include <sys/stat.h>
#include <tendon/base/log.h>
#include <tendon/gcm/step_history.h>
#include <tests/support/folder.h>
#include <tests/support/wait.h>

#include <fstream>
#include <future>
#include <memory>
#include <mutex>

namespace tendon {
namespace {

message::HistoryEntry Step(int number) {
  const std::string interface = "Robot" + std::to_string(number);
  return {.verb = number % 2 == 0 ? "connect" : "disconnect",
          .ends = {{"desk", "teleoperation", interface}, {"robot", "arm", "Control"}},
          .who = "gcm \"connect\"\n",
          .when = 1'700'000'000'000'000'000 + number,
          .instance = 0xfedcba9876543210U};
}

/// Adds the step, waits until it is saved, and returns it with its number.
message::HistoryEntry Record(StepHistory& history, message::HistoryEntry step) {
  std::promise<void> kept;
  step.id = history.Record(step, [&] { kept.set_value(); });
  kept.get_future().wait();
  return step;
}

TEST(StepHistory, KeepsItsStepsAcrossARestart) {
  const test::Folder folder;
  const auto file = folder.path() / "history.jsonl";
  std::vector<message::HistoryEntry> steps;
  int kept = 0;
  {
    StepHistory history(file);
    for (int i = 0; i < 60; ++i) {
      steps.push_back(Step(i));
      steps.back().id = history.Record(steps.back(), [&kept] { ++kept; });
    }
    steps[59].undone = true;
    history.MarkUndone(steps[59].id, [&kept] { ++kept; });
    steps[58].passed_over = true;
    history.MarkPassedOver(steps[58].id, [&kept] { ++kept; });
  }

  EXPECT_EQ(kept, 62);  // the last steps wait for the disk
  const StepHistory again(file);

  EXPECT_EQ(again.steps().entries, steps);
  EXPECT_EQ(again.last(), steps[57]);
}

TEST(StepHistory, KeepsTheAuthorOfAnUndoAcrossARestart) {
  const test::Folder folder;
  const auto file = folder.path() / "history.jsonl";
  {
    StepHistory history(file);
    history.MarkUndone(Record(history, Step(0)).id, [] {}, {.who = "gcm \"undo\"\n", .when = 7});
    history.MarkUndone(Record(history, Step(1)).id, [] {});
  }
  // An incomplete line, which is repaired.
  folder.Write("history.jsonl", folder.Read("history.jsonl") + "{\"id\"");

  for (int restart = 0; restart < 2; ++restart) {
    const StepHistory again(file);
    EXPECT_EQ(again.undo_of(1).who, "gcm \"undo\"\n");
    EXPECT_EQ(again.undo_of(1).when, 7);
    EXPECT_EQ(again.undo_of(2).who, "");
    EXPECT_EQ(again.last(), std::nullopt);
  }
  EXPECT_EQ(folder.Read("history.jsonl").find("{\"id\"\n"), std::string::npos);
}

TEST(StepHistory, IgnoresAnUndoOfAMissingStep) {
  const test::Folder folder;
  const auto file = folder.path() / "h";
  folder.Write("h", R"({"undo":7,"who":"gcm undo","when":3})"
                    "\n");
  StepHistory history(file);
  EXPECT_EQ(history.undo_of(7).who, "");

  history.MarkUndone(8, [] {}, {.who = "gcm undo", .when = 4});

  EXPECT_EQ(history.undo_of(8).who, "");
}

TEST(StepHistory, KeepsAReplacedConnectionAcrossARestart) {
  const test::Folder folder;
  const auto file = folder.path() / "history.jsonl";
  message::HistoryEntry step = Step(0);
  step.verb = "replace";
  step.former = {"robot", "second", "Control"};
  {
    StepHistory history(file);
    step = Record(history, step);
  }

  EXPECT_EQ(StepHistory(file).last(), step);
}

TEST(StepHistory, KeepsLifeCycleStepsAcrossARestart) {
  const test::Folder folder;
  const auto file = folder.path() / "history.jsonl";
  message::HistoryEntry step{.verb = "remove",
                             .lifecycle = {.process = "robot",
                                           .component = "arm",
                                           .class_name = "SimulatedArm",
                                           .library = "simulated_arm",
                                           .configuration = R"({"noise":0.1,"name":"\u00e9\n"})",
                                           .state = ComponentState::kActive,
                                           .connections = {{{"desk", "teleoperation", "Robot"},
                                                            {"robot", "arm", "Control"}}}},
                             .who = "gcm rm",
                             .when = 1'700'000'000'000'000'000};
  {
    StepHistory history(file);
    step = Record(history, step);
  }

  EXPECT_EQ(StepHistory(file).last(), step);
  EXPECT_EQ(ToString(step), "remove robot/arm");
  EXPECT_EQ(ToString(Step(0)), "connect desk/teleoperation/Robot0 robot/arm/Control");
}

TEST(StepHistory, IgnoresATruncatedLastLine) {
  const test::Folder folder;
  const auto file = folder.path() / "history.jsonl";
  StepHistory history(file);
  const auto first = Record(history, Step(0));
  const std::string one = folder.Read("history.jsonl");
  Record(history, Step(1));
  const std::string two = folder.Read("history.jsonl");
  for (std::size_t size = one.size(); size < two.size(); ++size) {
    folder.Write("history.jsonl", two.substr(0, size));

    EXPECT_EQ(StepHistory(file).steps().entries, std::vector{first}) << size;

    ASSERT_EQ(folder.Read("history.jsonl"), one) << size;  // as if the file had never been cut off
  }
  StepHistory torn(file);
  const auto third = Record(torn, Step(2));
  EXPECT_EQ(torn.steps().entries, (std::vector{first, third}));
  EXPECT_EQ(StepHistory(file).steps().entries, (std::vector{first, third}));
}

TEST(StepHistory, SkipsOnlyTheUnreadableLine) {
  const test::Folder folder;
  std::vector<message::HistoryEntry> both;
  {
    StepHistory history(folder.path() / "h");
    both = {Record(history, Step(0)), Record(history, Step(1))};
  }
  const std::string text = folder.Read("h");
  const std::size_t end = text.find('\n') + 1;
  for (const std::string bad : {"", "nonsense", "[]", "{\"id\":7}", "{\"undo\":\"x\"}", "17",
                                "{\"id\":1,\"verb\":\"connect\",\"required\":\"a\","
                                "\"provided\":\"b\",\"who\":\"x\",\"when\":1}"}) {
    folder.Write("h", text.substr(0, end) + bad + "\n" + text.substr(end));
    EXPECT_EQ(StepHistory(folder.path() / "h").steps().entries, both) << bad;
  }
}

TEST(StepHistory, AMissingFileIsAnEmptyHistory) {
  const test::Folder folder;
  const StepHistory history(folder.path() / "none");
  EXPECT_TRUE(history.steps().entries.empty());
  EXPECT_FALSE(history.last());
}

TEST(StepHistory, KeepsTheNewestStepsWhenThereAreTooMany) {
  const test::Folder folder;
  std::string text;
  {
    StepHistory history(folder.path() / "h");
    Record(history, Step(0));
    text = folder.Read("h");
  }
  std::string many;
  for (std::size_t i = 0; i < StepHistory::kMaxSteps + 10; ++i) {
    std::string line = text;
    many += line.replace(line.find("1"), 1, std::to_string(i + 1));
  }
  folder.Write("h", many);

  const auto steps = StepHistory(folder.path() / "h").steps().entries;

  ASSERT_EQ(steps.size(), StepHistory::kMaxSteps);
  EXPECT_EQ(steps.front().id, 11U);
  EXPECT_LT(folder.Read("h").size(), many.size());
}

TEST(StepHistory, KeepsNoMoreThanItsBytesOfLargeStepsNorALargerFile) {
  const test::Folder folder;
  const auto file = folder.path() / "h";
  message::HistoryEntry large{.verb = "configure", .lifecycle = {.process = "robot"}};
  large.lifecycle.former.assign(StepHistory::kMaxBytes / 4, 'x');
  {
    StepHistory history(file);
    for (int i = 0; i < 10; ++i) Record(history, large);
    EXPECT_EQ(history.steps().entries.size(), 3U);
  }

  EXPECT_LT(folder.Read("h").size(), 3 * StepHistory::kMaxBytes);
  const StepHistory again(file);
  EXPECT_EQ(again.steps().entries.size(), 3U);
  EXPECT_EQ(again.last()->id, 10U);
}

TEST(StepHistory, LogsAWriteErrorAndKeepsTheStep) {
  // Shared, because the log sink outlives this test.
  const auto logged = std::make_shared<std::string>();
  AddLogSink([logged](LogLevel, std::string_view, std::string_view text) { *logged += text; });
  StepHistory history("/proc/nowhere/history");

  const auto step = Record(history, Step(0));
  history.Close();

  EXPECT_NE(logged->find("cannot write /proc/nowhere/history"), std::string::npos) << *logged;
  EXPECT_EQ(history.last(), step);
}

TEST(StepHistory, LogsAnUnwritableFolderAtTheStart) {
  // Shared, because the log sink outlives this test.
  const auto logged = std::make_shared<std::string>();
  const auto mutex = std::make_shared<std::mutex>();
  AddLogSink([logged, mutex](LogLevel, std::string_view, std::string_view text) {
    const std::scoped_lock lock(*mutex);
    *logged += text;
  });

  const StepHistory history("/proc/elsewhere/history");

  EXPECT_TRUE(EventuallyTrue([&] {
    const std::scoped_lock lock(*mutex);
    return logged->find(
               "the history is not saved: cannot write /proc/elsewhere/history: No such file or "
               "directory; steps can be undone only until this GCM ends") != std::string::npos;
  }));
}

TEST(StepHistory, APartialWriteCorruptsNoLaterLine) {
  const test::Folder folder;
  const auto file = folder.path() / "h";
  StepHistory history(file);
  const auto first = Record(history, Step(0));
  std::filesystem::rename(file, folder.path() / "kept");
  std::filesystem::create_directory(file);  // a folder, to which nothing can be appended
  Record(history, Step(1));
  std::filesystem::remove(file);
  // The part of a line that a full disk accepted.
  folder.Write("h", folder.Read("kept") + "{\"id\":2,\"ve");

  const auto third = Record(history, Step(2));

  EXPECT_EQ(StepHistory(file).steps().entries, (std::vector{first, third}));
}

TEST(StepHistory, AStepIsAvailableWhileTheDiskIsSlow) {
  const test::Folder folder;
  const auto file = folder.path() / "h";
  StepHistory history(file);
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);  // opening the pipe blocks until it is read
  std::vector<int> done;
  const auto first = history.Record(Step(0), [&] { done.push_back(0); });
  history.Record(Step(1), [&] { done.push_back(1); });
  history.MarkUndone(2, [&] { done.push_back(2); });

  EXPECT_EQ(history.last()->id, first);
  EXPECT_EQ(history.steps().entries.size(), 2U);

  const std::ifstream disk_that_works_again(file);
  history.Close();
  EXPECT_EQ(done, (std::vector{0, 1, 2}));
}

}  // namespace
}  // namespace tendon
