#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/middleware/body.h>

#include "support/folder.h"
#include "system/faults/harness/command_checker.h"
#include "system/faults/harness/process_watch.h"
#include "system/faults/harness/stream_checker.h"

// The checkers of the fault tests must detect mistakes.

namespace faults {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Writes journals as one client and one ledger might have left them.
class CommandChecker : public testing::Test {
 protected:
  void Given(const std::string& lines) const { folder_.Write("given-7", lines); }
  void Executed(const std::vector<std::uint64_t>& numbers) const {
    std::string lines;
    for (const std::uint64_t number : numbers) {
      lines += "7 " + std::to_string(number) + " " + std::to_string(CheckOf(7, number)) + "\n";
    }
    folder_.Write("executed-1", lines);
  }
  [[nodiscard]] std::vector<std::string> Mistakes() const {
    return CheckCommands(folder_.path()).mistakes;
  }

  const tendon::test::Folder folder_;
};

TEST_F(CommandChecker, AcceptsHonestResults) {
  Given("1 given\n1 done\n2 given\n2 timeout\n3 given\n3 outcome unknown\n4 given\n5 given\n");
  Executed({1, 3, 5});

  EXPECT_THAT(Mistakes(), IsEmpty());
}

TEST_F(CommandChecker, DetectsADoneCommandThatWasNotExecuted) {
  Given("1 given\n1 done\n");
  EXPECT_THAT(Mistakes(), ElementsAre(HasSubstr("executed 0 times")));
}

TEST_F(CommandChecker, DetectsARefusedCommandThatWasExecuted) {
  Given("1 given\n1 timeout\n");
  Executed({1});
  EXPECT_THAT(Mistakes(), ElementsAre(HasSubstr("executed 1 times")));
}

TEST_F(CommandChecker, DetectsACommandExecutedTwice) {
  Given("1 given\n1 done\n2 given\n");
  Executed({1, 2, 2, 1});
  EXPECT_THAT(Mistakes(), ElementsAre(HasSubstr("executed 2"), HasSubstr("executed 2")));
}

TEST_F(CommandChecker, DetectsACommandThatWasNeverGiven) {
  Executed({9});
  EXPECT_THAT(Mistakes(), ElementsAre(HasSubstr("never given")));
}

TEST_F(CommandChecker, DetectsDamage) {
  Given("1 given\n1 done\n");
  folder_.Write("executed-1", "7 1 12345\n");
  EXPECT_THAT(Mistakes(), ElementsAre(HasSubstr("damaged")));
}

/// Passes samples with these numbers to a checker. Each sample is in the row with the tick of the
/// same index.
StreamChecker::Verdict Judge(const std::vector<Numbered>& samples,
                             const std::vector<std::uint64_t>& ticks) {
  StreamChecker checker;
  std::vector<tendon::Bytes> cells;
  for (const Numbered& sample : samples) cells.push_back(tendon::EncodeBody(sample));
  tendon::RowBatch batch;
  batch.count = samples.size();
  batch.ticks = ticks;
  batch.cell = [&](std::size_t row, std::size_t /*column*/) {
    return std::span<const std::byte>(cells[row]);
  };
  static_cast<tendon::RowSink&>(checker).OnRows(batch);
  return checker.verdict();
}

TEST(StreamChecker, AcceptsAnUnbrokenStream) {
  const auto verdict = Judge({MakeNumbered(7, 1), MakeNumbered(7, 2)}, {0, 1});
  EXPECT_EQ(verdict.received, 2U);
  EXPECT_EQ(verdict.missing + verdict.repeated + verdict.damaged, 0U);
  EXPECT_EQ(verdict.ledgers, 1U);
}

TEST(StreamChecker, DetectsMissingRows) {
  EXPECT_EQ(Judge({MakeNumbered(7, 1), MakeNumbered(7, 5)}, {0, 1}).missing, 3U);
}

TEST(StreamChecker, DetectsRepeatedAndReorderedRows) {
  EXPECT_EQ(Judge({MakeNumbered(7, 5), MakeNumbered(7, 5)}, {0, 1}).repeated, 1U);
  EXPECT_EQ(Judge({MakeNumbered(7, 5), MakeNumbered(7, 4)}, {0, 1}).repeated, 1U);
  EXPECT_EQ(Judge({MakeNumbered(7, 5), MakeNumbered(7, 6)}, {1, 1}).repeated, 1U);
}

TEST(StreamChecker, DetectsDamageAndAnotherSource) {
  EXPECT_EQ(Judge({{.source = 7, .number = 1, .check = 2}}, {0}).damaged, 1U);
  EXPECT_EQ(Judge({MakeNumbered(7, 5), MakeNumbered(8, 1)}, {0, 1}).ledgers, 2U);
}

TEST(ProcessWatch, DetectsTwoHoldersOfOneName) {
  ProcessWatch watch;
  const auto see = [&](std::uint64_t instance, tendon::ProcessState state) {
    tendon::CatalogueChange change;
    change.processes = {{.name = "robot", .instance = instance, .state = state}};
    static_cast<tendon::GcmListener&>(watch).OnChanges({change});
  };
  see(1, tendon::ProcessState::kAlive);
  see(1, tendon::ProcessState::kLost);
  see(2, tendon::ProcessState::kAlive);
  EXPECT_THAT(watch.double_holders(), IsEmpty());
  EXPECT_EQ(watch.Count("robot", tendon::ProcessState::kAlive), 2U);

  see(3, tendon::ProcessState::kAlive);

  EXPECT_THAT(watch.double_holders(), ElementsAre("robot"));
}

}  // namespace
}  // namespace faults
