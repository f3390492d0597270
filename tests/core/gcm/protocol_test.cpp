#include <gtest/gtest.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/middleware/handshake.h>
#include <tendon/process/history/history_messages.h>
#include <tendon/process/version_messages.h>
#include <tendon/process/viewer_messages.h>
#include <tendon/proxy/connection_messages.h>

#include <string>

namespace tendon {
namespace {

template <Payload... Messages>
Fingerprint FingerprintOfAll() {
  std::string texts;
  ((texts += SchemaOf<Messages>().Text()), ...);
  return FingerprintOf(texts);
}

Fingerprint MessagesOfVersion11() {
  return FingerprintOfAll<
      Error, message::Greeting, message::Challenge, message::Proof,  // middleware
      message::OpenInterface, message::OpenInterfaceReply, message::Credit, message::EventsLost,
      message::Pong, message::Mirror, message::MirrorReply,  // proxy
      message::GetSchemas, message::Schemas, message::CallMember, message::CallMemberReply,
      message::Subscribe, message::SubscribeReply, message::RowsHeader,
      message::ProgramVersion,  // process
      message::Join, message::JoinReply, message::Report, message::ConnectionPlan,
      message::PeerList, ConnectionDescription, message::Health, message::GcmClock,
      // membership
      message::CatalogueSnapshot, message::Changes, message::ConnectionEnds, message::HistoryEntry,
      message::History, message::ForgetProcess, message::LogRecords, message::SetLogLevel,
      message::WatchLog, message::WatchLogReply, message::LifecycleOrder, message::LifecycleOutcome,
      message::BeginOrder, message::GetClasses, message::Classes, message::StepSelection,
      message::SystemHealth, message::ProcessOrder, message::Children>();  // gcm
}

TEST(Protocol, ChangedMessagesRequireANewVersion) {
  // If this fingerprint changes, programs of the old and the new version would misread each other's
  // messages. Raise FrameHeader::kProtocolVersion, and write both new values here.
  EXPECT_EQ(FrameHeader::kProtocolVersion, 11);
  EXPECT_EQ(ToString(MessagesOfVersion11()), "1f97dcf6806133c0fe0cc9c0eaac56a0");
  // Add messages that are newer than this version here, with their own fingerprint. A program that
  // does not know a message refuses it by its number.
  EXPECT_EQ(ToString(FingerprintOfAll<message::ReadRows, message::ReadRowsReply>()),
            "5910a05dc5cf3af6bca7efc89db06a95");
  EXPECT_EQ(
      ToString(FingerprintOfAll<message::ReadEvents, message::ReadEventsReply, message::ReadLog,
                                message::ReadLogReply, message::ProcessHistoryState>()),
      "5ce0ed6f63aef94068efc4b984bdaa78");
}

}  // namespace
}  // namespace tendon
