#include <gcm_gui/diagnosis/signature_diff.h>
#include <gcm_gui/diagnosis/signature_model.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>

#include "support/sample_system.h"

namespace tendon::gui {
namespace {

using Verdict = SignatureRow::Verdict;

class SignatureDiffTest : public ::testing::Test {
 protected:
  SignatureDiffTest() {
    required_.functions = {Write("MoveTo", "arm.Goal"), Read("GetJoints", "arm.Joints"),
                           Void("Stop")};
    required_.event_handlers = {Void("GoalReached")};
    provided_.commands = {Void("Stop"), Read("MoveTo", "arm.Goal"), Read("GetJoint", "arm.Joints")};
    provided_.events = {Void("GoalReached"), Void("LimitExceeded")};
  }

  RequiredDescription required_;
  ProvidedDescription provided_;
};

TEST_F(SignatureDiffTest, PairsNeededMembersWithOfferedOnes) {
  const auto rows = SignatureDiff(required_, provided_);

  std::vector<Verdict> verdicts;
  for (const auto& row : rows) verdicts.push_back(row.verdict);
  EXPECT_EQ(verdicts, (std::vector{Verdict::kChanged, Verdict::kMissing, Verdict::kSame,
                                   Verdict::kSame, Verdict::kUnneeded, Verdict::kUnneeded}));
  EXPECT_EQ(rows[0].remark,
            "needs write command 'MoveTo' of arm.Goal, but the provider offers a read one");
  EXPECT_EQ(rows[1].remark, "missing; did you mean 'GetJoint'?");
  EXPECT_EQ(rows[4].offered->name, "GetJoint");
  EXPECT_TRUE(rows[5].is_event);
}

TEST_F(SignatureDiffTest, OptionalMembersMayBeMissing) {
  required_.functions = {Void("Home")};
  required_.functions.front().optional = true;
  required_.event_handlers.clear();

  const auto rows = SignatureDiff(required_, {});

  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows.front().verdict, Verdict::kWithout);
  EXPECT_FALSE(rows.front().is_bad());
}

TEST_F(SignatureDiffTest, MarksExactlyTheMismatchesAsBad) {
  const auto rows = SignatureDiff(required_, provided_);

  const auto bad =
      std::count_if(rows.begin(), rows.end(), [](const auto& r) { return r.is_bad(); });
  EXPECT_EQ(static_cast<std::size_t>(bad), Compare(required_, provided_).mismatches.size());
}

TEST_F(SignatureDiffTest, TheModelHasThreeColumns) {
  SignatureModel model;
  const QAbstractItemModelTester tester(&model);

  model.show(required_, provided_);

  EXPECT_EQ(model.index(0, SignatureModel::kNeeded).data().toString(), "MoveTo");
  EXPECT_EQ(model.index(0, SignatureModel::kVerdict).data().toString(), "other kind");
  EXPECT_EQ(model.index(1, SignatureModel::kOffered).data().toString(), "–");
  EXPECT_EQ(model.index(1, SignatureModel::kVerdict).data().toString(),
            "missing; did you mean 'GetJoint'?");
  EXPECT_EQ(model.index(0, 0).data(Qt::AccessibleTextRole).toString(),
            "MoveTo write Goal offered MoveTo read Goal other kind needs write command 'MoveTo' of "
            "arm.Goal, but the provider offers a read one");
}

}  // namespace
}  // namespace tendon::gui
