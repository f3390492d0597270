#include <gtest/gtest.h>
#include <tendon/gcm/text/version_text.h>

namespace tendon {
namespace {

const message::ProgramVersion kOwn{.release = "1.2.3", .protocol = 7};

TEST(VersionText, OfTheSameReleaseIsTheOwn) {
  const VersionReport told = JudgeVersion(kOwn, kOwn);
  EXPECT_EQ(told.text, "version 1.2.3, protocol 7");
  EXPECT_TRUE(told.is_own);
}

TEST(VersionText, OfAnotherReleaseOrProtocolIsSaid) {
  for (const message::ProgramVersion& other :
       {message::ProgramVersion{.release = "1.2.4", .protocol = 7},
        message::ProgramVersion{.release = "1.2.3", .protocol = 6}}) {
    const VersionReport told = JudgeVersion(other, kOwn);
    EXPECT_EQ(told.text, VersionText(other) + ", which is not that of this program");
    EXPECT_FALSE(told.is_own);
  }
}

TEST(VersionText, AProgramThatDoesNotKnowTheQuestionIsOlder) {
  const VersionReport told =
      JudgeVersion(Error{ErrorCode::kDenied, "'message 525' is not allowed to anybody"}, kOwn);
  EXPECT_EQ(told.text, "of an old version that does not report itself");
  EXPECT_FALSE(told.is_own);
}

TEST(VersionText, WhoDoesNotAnswerIsNotCalledOld) {
  const VersionReport told = JudgeVersion(Error{ErrorCode::kTimeout, "no answer"}, kOwn);
  EXPECT_EQ(told.text, "of an unknown version (no answer)");
  EXPECT_FALSE(told.is_own);
}

}  // namespace
}  // namespace tendon
