#include <gtest/gtest.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/process/broadcast_messages.h>
#include <tendon/process/guarded_handler.h>
#include <tendon/process/history/history_messages.h>
#include <tendon/process/membership_messages.h>
#include <tendon/process/version_messages.h>
#include <tendon/process/viewer_messages.h>
#include <tendon/proxy/connection_messages.h>
#include <tendon/security/rights.h>

#include <cstdint>
#include <set>

namespace tendon {
namespace {

using Types = std::set<MessageType>;

/// The messages that a viewer may send.
const Types kLooks = {message::kPing,        message::kGetSchemas,       message::kSubscribe,
                      message::kUnsubscribe, message::kRowTaken,         message::kRenew,
                      message::kWatch,       message::kHistory,          message::kWatchLog,
                      message::kGetClasses,  message::kListen,           message::kCloseInterface,
                      message::kHealth,      message::kGetCounts,        message::kGetFill,
                      message::kJoinTopic,   message::kGetBroker,        message::kGetProgram,
                      message::kReadRows,    message::kGetChildren,      message::kReadEvents,
                      message::kReadLog,     message::kGetProcessHistory};

/// The further messages that an operator may send.
const Types kActs = {
    message::kOpenInterface,  message::kCommands,   message::kRead,       message::kWait,
    message::kEventsLost,     message::kCallMember, message::kJoin,       message::kReport,
    message::kLeave,          message::kConnect,    message::kDisconnect, message::kUndo,
    message::kForget,         message::kReplace,    message::kLogRecords, message::kSetLogLevel,
    message::kLifecycleOrder, message::kSkipStep,   message::kBeginOrder, message::kReportHealth,
    message::kProcess,        message::kMirror,     message::kPlanLock};

/// Compares names, so that a wrong number in the table is noticed.
TEST(Rights, CoverEveryMessage) {
  for (unsigned number = 0; number <= UINT16_MAX; ++number) {
    const auto type = static_cast<MessageType>(number);
    const Right* right = FindRight(static_cast<std::uint16_t>(number));
    if (kLooks.contains(type)) {
      ASSERT_NE(right, nullptr) << number;
      EXPECT_EQ(right->role, Role::kViewer) << number;
    } else if (kActs.contains(type)) {
      ASSERT_NE(right, nullptr) << number;
      EXPECT_EQ(right->role, Role::kOperator) << number;
    } else {
      EXPECT_EQ(right, nullptr) << number << ": what nobody thought of is denied";
    }
  }
}

TEST(Rights, AuditEveryChangeOfTheSystem) {
  // A program tries to open an interface or to join until it succeeds. Other records report the
  // success, so these messages are not audited.
  const Types written = {message::kCallMember, message::kLeave,       message::kConnect,
                         message::kDisconnect, message::kUndo,        message::kForget,
                         message::kReplace,    message::kSetLogLevel, message::kLifecycleOrder,
                         message::kSkipStep,   message::kProcess};
  for (const Right& right : kRights) {
    EXPECT_EQ(right.audit == Audit::kAll, written.contains(static_cast<MessageType>(right.type)))
        << right.act;
  }
}

TEST(Rights, OfAnOperatorIncludeThoseOfAViewer) {
  EXPECT_TRUE(Includes(Role::kOperator, Role::kViewer));
  EXPECT_TRUE(Includes(Role::kViewer, Role::kViewer));
  EXPECT_FALSE(Includes(Role::kViewer, Role::kOperator));
}

}  // namespace
}  // namespace tendon
