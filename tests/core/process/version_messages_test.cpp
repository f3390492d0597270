#include <gtest/gtest.h>
#include <tendon/middleware/pending_requests.h>
#include <tendon/process/history/history_messages.h>
#include <tendon/process/version_messages.h>
#include <tendon/process/viewer_messages.h>

#include <chrono>

namespace tendon {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

TEST(ExplainFailure, ARequestThatOnlyReadsHasNoUnknownOutcome) {
  const Error failure = ExplainFailure(NoReply("robot", 500ms), message::kReadLog, "robot");

  EXPECT_EQ(failure, (Error{ErrorCode::kTimeout, "no reply from robot within 500 ms"}));
}

TEST(ExplainFailure, ACallWithoutAReplyHasAnUnknownOutcome) {
  const Error failure = ExplainFailure(NoReply("robot", 500ms), message::kCallMember, "robot");

  EXPECT_EQ(failure, NoReply("robot", 500ms));
}

}  // namespace
}  // namespace tendon
