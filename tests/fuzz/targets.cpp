#include "targets.h"

#include <tendon/middleware/frame.h>
#include <tendon/middleware/handshake.h>
#include <tendon/middleware/reply_batch.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/payload/json.h>
#include <tendon/payload/numeric_field.h>
#include <tendon/payload/schema/ros_parser.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "export_recording.h"
#include "promise.h"
#include "read_recording.h"
#include "typed_decode.h"
#include "use_recording.h"

namespace fuzz {
namespace {

/// Decodes a body by a schema. The first two bytes are the length of the schema's text, which
/// follows; the rest is the body.
void DecodeBySchema(Bytes bytes) {
  constexpr std::size_t kMaxRead = 8;
  if (bytes.size() < 2) return;
  const std::size_t length = std::min(
      std::to_integer<std::size_t>(bytes[0]) + std::to_integer<std::size_t>(bytes[1]) * 256,
      bytes.size() - 2);
  const auto schema = tendon::Schema::Parse(TextOf(bytes.subspan(2, length)));
  if (!schema) return;
  const Bytes rest = bytes.subspan(2 + length);
  // A separate copy, so that a sanitizer detects reads beyond its end.
  const std::vector<std::byte> body(rest.begin(), rest.end());

  if (const auto json = tendon::ToJson(*schema, body)) {
    const auto again = tendon::FromJson(*schema, *json);
    Require(!again || tendon::ToJson(*schema, *again).ok(), "what was read prints");
  }
  const auto fields = tendon::NumericFields(*schema, body);
  for (std::size_t i = 0; i < std::min(fields.size(), kMaxRead); ++i) {
    const auto number = tendon::ReadAsDouble(fields[i], body);
    Require(number.has_value(), "a field of a body reads");
    const auto found = tendon::FindNumericField(*schema, fields[i].path);
    Require(found && found->route == fields[i].route, "a field is found by its path");
    const auto again = tendon::ReadAsDouble(*found, body);
    Require(again && std::memcmp(&*again, &*number, sizeof(double)) == 0,
            "a field reads the same however it was found");
  }
}

void ReadSchema(Bytes bytes) {
  const auto schema = tendon::Schema::Parse(TextOf(bytes));
  if (!schema) return;
  const auto canonical = tendon::Schema::Parse(schema->Text());
  Require(canonical && canonical->Text() == schema->Text(), "a canonical text reads back");
  const auto full = tendon::Schema::Parse(schema->TextWithHelp());
  Require(full && full->TextWithHelp() == schema->TextWithHelp(), "a full text reads back");
  Require(full->fingerprint() == schema->fingerprint(), "help is not in the fingerprint");
  Require(!tendon::FirstDifference(*schema, *canonical), "a type does not differ from itself");
  Require(schema->minimum_size() >= 1, "every value takes a byte");
  (void)tendon::RosMessage(*schema);
  (void)tendon::NumericFields(*schema);
}

void ReadRosMessage(Bytes bytes) {
  const auto schema = tendon::ParseRosMessage("a/msg/B", TextOf(bytes));
  if (!schema) return;
  const auto again =
      tendon::ParseRosMessage(tendon::RosTypeName(*schema), tendon::RosMessage(*schema));
  Require(again && again->Text() == schema->Text(), "a printed message reads back");
}

/// Reads the bytes as consecutive frames, the first frames on a link. Version 0 stands for the
/// present version, so that the corpus remains valid when the version changes.
void ReadFrames(Bytes bytes, tendon::Handshake::Role role) {
  const tendon::Hello mine{.instance = 1, .name = "robot", .session = 2, .cookie = 7};
  tendon::Handshake handshake(role, mine, "127.0.0.1:1", tendon::UnauthenticatedPeers::kRefused);
  if (role == tendon::Handshake::Role::kOpener) (void)handshake.Greet();
  while (true) {
    auto header = tendon::ReadFrameHeader(bytes, tendon::kMaxUnauthenticatedFrameSize);
    if (!header) return;
    if (header->version == 0) header->version = tendon::FrameHeader::kProtocolVersion;
    const std::size_t size = tendon::FrameHeader::kSize + header->size;
    Require(size <= tendon::kMaxUnauthenticatedFrameSize, "an unauthenticated frame is bounded");
    if (bytes.size() < size) return;
    Require(tendon::ReadWholeFrame(bytes.first(size)).has_value(), "a whole frame is one");
    const Bytes inner = bytes.subspan(tendon::FrameHeader::kSize, header->size);
    // A separate copy, so that a sanitizer detects reads beyond its end.
    const std::vector<std::byte> body(inner.begin(), inner.end());
    (void)tendon::ReadRefusal(body, "peer");
    if (tendon::IsReplyBatch(body)) {
      Bytes rest = body;
      while (tendon::TakeReply(rest)) {
      }
      Require(rest.empty(), "a batch of answers is whole");
    }
    const auto step = handshake.Take(*header, body);
    if (!step) return;
    Require(!step->peer, "who does not know the cookie is refused");
    bytes = bytes.subspan(size);
  }
}

void ReadFrames(Bytes bytes) {
  ReadFrames(bytes, tendon::Handshake::Role::kAcceptor);
  ReadFrames(bytes, tendon::Handshake::Role::kOpener);
}

}  // namespace

std::span<const Target> Targets() {
  static constexpr std::array kTargets{
      Target{.name = "csv_export", .run = ExportAsCsv, .corpus = "recorded", .rounds = 1000},
      Target{"frame", ReadFrames},
      Target{.name = "hdf5_export", .run = ExportAsHdf5, .corpus = "recorded", .rounds = 600},
      Target{"json", ReadJson},
      Target{"recording", ReadRecording},
      Target{.name = "replay", .run = ReplayRecording, .corpus = "recorded", .rounds = 600},
      Target{"ros_text", ReadRosMessage},
      Target{"schema_decode", DecodeBySchema},
      Target{"schema_text", ReadSchema},
      Target{"typed_decode", DecodeTyped}};
  return kTargets;
}

}  // namespace fuzz
