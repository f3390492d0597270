#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/folder.h>
#include <tendon/gcm/text.h>
#include <tendon/interface/observed_call.h>
#include <tendon/payload/codec.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/recording_writer.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "recordings.h"

namespace tendon::recording {

struct Reading {
  double angle = 0.0;
  std::string note;
};

}  // namespace tendon::recording

template <>
inline constexpr auto tendon::kPayload<tendon::recording::Reading> = tendon::Describe(
    "arm.Reading", tendon::Field{"angle", &tendon::recording::Reading::angle, "rad"},
    tendon::Field{"note", &tendon::recording::Reading::note});

namespace tendon::recording {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Pair;

std::shared_ptr<const EntrySource> ArmTable() {
  auto source = std::make_shared<EntrySource>();
  source->name = {"robot", "arm", "state"};
  source->members = {{"Reading", SchemaOf<Reading>()}, {"Count", SchemaOf<std::uint64_t>()}};
  return source;
}

RowsEntry RowsOf(std::shared_ptr<const EntrySource> source, std::uint64_t first, std::size_t count,
                 std::uint64_t epoch = 1) {
  RowsEntry rows;
  rows.source = std::move(source);
  rows.epoch = epoch;
  for (std::uint64_t tick = first; tick < first + count; ++tick) {
    rows.ticks.push_back(tick);
    rows.times.push_back(static_cast<std::int64_t>(1'000'000 * tick));
    std::vector<std::byte> reading;
    std::vector<std::byte> number;
    Encode(Reading{static_cast<double>(tick), "of " + std::to_string(tick)}, reading);
    Encode(tick, number);
    for (const auto& cell : {reading, number}) {
      rows.cell_sizes.push_back(static_cast<std::uint32_t>(cell.size()));
      rows.cells.insert(rows.cells.end(), cell.begin(), cell.end());
    }
  }
  return rows;
}

class RecordingWriterTest : public testing::Test {
 protected:
  std::unique_ptr<RecordingWriter> Create(FileOptions options = {}) {
    options.file = folder.path() / "run.mcap";
    auto writer = RecordingWriter::Create(options, {{{"paths", "robot/**"}}, R"({"version": 1})"});
    EXPECT_TRUE(writer) << writer.error().message;
    return *std::move(writer);
  }
  std::unique_ptr<mcap::Reader> Open(const std::string& name = "run.mcap") {
    auto reader = mcap::Reader::Open(folder.path() / name);
    EXPECT_TRUE(reader) << reader.error().message;
    if (!reader) return nullptr;
    EXPECT_EQ(mcap::FlawsOf(**reader), "");
    return *std::move(reader);
  }
  static std::vector<mcap::StoredMessage> MessagesOf(mcap::Reader& reader,
                                                     const std::string& topic) {
    auto all = mcap::ReadAll(reader);
    std::erase_if(all, [&](const auto& message) { return message.topic != topic; });
    return all;
  }

  const test::Folder folder;
};

TEST_F(RecordingWriterTest, ARowIsAMessageOnEachColumnWithItsTickAsTheSequence) {
  const auto writer = Create();
  ASSERT_TRUE(writer->Write(RowsOf(ArmTable(), 5, 3)));
  ASSERT_TRUE(writer->Close({}));

  const auto reader = Open();
  EXPECT_EQ(reader->header().profile, "ros2");
  const auto readings = MessagesOf(*reader, "robot/arm/state/Reading");
  const auto counts = MessagesOf(*reader, "robot/arm/state/Count");
  ASSERT_EQ(readings.size(), 3U);
  ASSERT_EQ(counts.size(), 3U);
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_EQ(readings[i].sequence, 5 + i);
    EXPECT_EQ(counts[i].sequence, 5 + i);
    EXPECT_EQ(readings[i].log_time, counts[i].log_time);
    EXPECT_EQ(readings[i].log_time - readings[0].log_time, 1'000'000U * i);
    EXPECT_EQ(ValueOf<Reading>(readings[i]).note, "of " + std::to_string(5 + i));
    EXPECT_EQ(ValueOf<std::uint64_t>(counts[i]), 5U + i);
  }
}

TEST_F(RecordingWriterTest, AChannelSaysWhereItsMessagesComeFromAndTheirUnits) {
  const auto writer = Create();
  ASSERT_TRUE(writer->Write(RowsOf(ArmTable(), 0, 1)));
  ASSERT_TRUE(writer->Close({}));

  const auto reader = Open();
  const mcap::Channel& channel = reader->channels().at(1);
  EXPECT_EQ(channel.topic, "robot/arm/state/Reading");
  EXPECT_EQ(channel.message_encoding, "cdr");
  EXPECT_THAT(channel.metadata, Contains(Pair(kPathKey, "robot/arm/state.Reading")));
  EXPECT_THAT(channel.metadata, Contains(Pair("tendon.unit.angle", "rad")));
  const auto schema = Schema::Parse(channel.metadata.at(kSchemaKey));
  ASSERT_TRUE(schema) << schema.error().message;
  EXPECT_EQ(*schema, SchemaOf<Reading>());
  EXPECT_EQ(reader->schemas().at(channel.schema_id).name, "arm/msg/Reading");
  EXPECT_EQ(reader->schemas().at(channel.schema_id).encoding, "ros2msg");
}

TEST_F(RecordingWriterTest, TimesAreThoseOfThisMachineAndTheSourcesOwnCanBeComputed) {
  const auto writer = Create();
  RowsEntry rows = RowsOf(ArmTable(), 0, 1);
  rows.clock_offset = std::chrono::seconds(5);
  rows.times[0] = SteadyClock().Now().time_since_epoch().count() + 5'000'000'000;
  const std::int64_t wall = WallTime();
  const std::int64_t time = rows.times[0];
  ASSERT_TRUE(writer->Write(rows));
  rows.clock_offset += std::chrono::microseconds(7);
  rows.ticks[0] = 1;
  ASSERT_TRUE(writer->Write(rows));
  ASSERT_TRUE(writer->Close({}));

  const auto reader = Open();
  const auto messages = MessagesOf(*reader, "robot/arm/state/Count");
  ASSERT_EQ(messages.size(), 2U);
  const auto& later = messages[0].sequence == 0 ? messages[0] : messages[1];
  const auto& earlier = messages[0].sequence == 0 ? messages[1] : messages[0];
  EXPECT_NEAR(static_cast<double>(later.log_time), static_cast<double>(wall), 1e9);
  EXPECT_EQ(later.log_time - earlier.log_time, 7000U) << "a larger offset is an earlier time";
  EXPECT_EQ(later.publish_time, earlier.publish_time);
  const std::int64_t clock = std::stoll(reader->channels().begin()->second.metadata.at(kClockKey));
  EXPECT_EQ(static_cast<std::int64_t>(later.publish_time) - clock, time);
}

TEST_F(RecordingWriterTest, ARestartedSourceGetsChannelsOfItsOwnAndARecoveredOneDoesNot) {
  const auto writer = Create();
  ASSERT_TRUE(writer->Write(RowsOf(ArmTable(), 0, 2, 1)));
  ASSERT_TRUE(writer->Write(RowsOf(ArmTable(), 2, 2, 1)));
  ASSERT_TRUE(writer->Write(RowsOf(ArmTable(), 0, 2, 2)));
  ASSERT_TRUE(writer->Close({}));

  const auto reader = Open();
  EXPECT_EQ(reader->channels().size(), 4U);
  EXPECT_EQ(MessagesOf(*reader, "robot/arm/state/Count").size(), 6U);
}

TEST_F(RecordingWriterTest, ALossIsAMessageBeforeTheRowsThatFollowAndInTheSummary) {
  const auto writer = Create();
  ASSERT_TRUE(writer->Write(RowsOf(ArmTable(), 0, 2)));
  RowsEntry late = RowsOf(ArmTable(), 10, 1);
  late.lost_before = {1, 2, 5};
  ASSERT_TRUE(writer->Write(late));
  Losses losses;
  losses.rows["robot/arm/state"] = {1, 2, 5};
  ASSERT_TRUE(writer->Close(losses));

  const auto reader = Open();
  const auto told = MessagesOf(*reader, kLossTopic);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(ValueOf<Loss>(told[0]), (Loss{"robot/arm/state", 1, 2, 5}));
  EXPECT_EQ(told[0].log_time, MessagesOf(*reader, "robot/arm/state/Count")[2].log_time);
  std::map<std::string, mcap::Metadata> metadata;
  for (const auto& index : reader->metadata()) metadata[index.name] = *reader->ReadMetadata(index);
  EXPECT_THAT(metadata[kLossMetadata].metadata,
              Contains(Pair("robot/arm/state", HasSubstr("5 in the recorder"))));
  EXPECT_THAT(metadata[kEndMetadata].metadata, Contains(Pair("rows", "3")));
  EXPECT_THAT(metadata[kAboutMetadata].metadata, Contains(Pair("paths", "robot/**")));
}

TEST_F(RecordingWriterTest, AnEventWithoutAValueHasTheByteOfAnEmptyMessage) {
  auto source = std::make_shared<EntrySource>();
  source->name = {"robot", "arm", "Control"};
  source->members = {{"Stopped", Schema()}, {"Moved", SchemaOf<double>()}};
  const auto writer = Create();
  std::vector<std::byte> value;
  Encode(2.5, value);
  const SteadyTime now = SteadyClock().Now();
  ASSERT_TRUE(writer->Write(EventEntry{source, 0, now, {}}));
  ASSERT_TRUE(writer->Write(EventEntry{source, 1, now, value}));
  ASSERT_TRUE(writer->Write(EventEntry{source, 0, now, {}}));
  ASSERT_TRUE(writer->Close({}));

  const auto reader = Open();
  const auto stopped = MessagesOf(*reader, "robot/arm/Control/Stopped");
  ASSERT_EQ(stopped.size(), 2U);
  EXPECT_EQ(stopped[0].data.size(), kEncapsulationSize + 1);
  EXPECT_EQ(stopped[1].sequence, 1U);
  EXPECT_EQ(ValueOf<double>(MessagesOf(*reader, "robot/arm/Control/Moved").at(0)), 2.5);
}

TEST_F(RecordingWriterTest, TheLogIsThatOfRos2FromTheBeginOn) {
  const auto writer = Create();
  const std::int64_t now = WallTime();
  ASSERT_TRUE(writer->Write(
      LogEntry{{now - 3'600'000'000'000, LogLevel::kError, "robot", "arm", "an hour ago"}}));
  ASSERT_TRUE(writer->Write(LogEntry{{now, LogLevel::kWarning, "robot", "arm", "too warm"}}));
  ASSERT_TRUE(writer->Close({}));

  const auto reader = Open();
  const auto records = MessagesOf(*reader, kLogTopic);
  ASSERT_EQ(records.size(), 1U);
  const auto log = ValueOf<RosLog>(records[0]);
  EXPECT_EQ(log.level, 30);
  EXPECT_EQ(log.name, "robot/arm");
  EXPECT_EQ(log.msg, "too warm");
  EXPECT_EQ(log.stamp.count(), now);
  EXPECT_EQ(reader->schemas().begin()->second.name, "rcl_interfaces/msg/Log");
  EXPECT_THAT(reader->schemas().begin()->second.data, HasSubstr("builtin_interfaces/Time stamp"));
}

TEST_F(RecordingWriterTest, EachFileOfASplitCanBeReadAloneAndTheOldestAreDropped) {
  const auto writer = Create(
      {.compression = mcap::Compression::kNone, .split_size = std::uint64_t{1} << 20U, .keep = 2});
  CatalogueEntry snapshot{.is_snapshot = true, .received = SteadyClock().Now(), .changes = {}};
  snapshot.changes.push_back({.revision = 1,
                              .kind = CatalogueChange::Kind::kProcess,
                              .process = "robot",
                              .processes = {{.name = "robot", .instance = 7}}});
  ASSERT_TRUE(writer->Write(snapshot));
  const auto table = ArmTable();
  std::uint64_t tick = 0;
  while (writer->counts().files < 4) {
    ASSERT_TRUE(writer->Write(RowsOf(table, tick, 1000)));
    tick += 1000;
    ASSERT_LT(tick, 1'000'000U) << "it never splits";
  }
  ASSERT_TRUE(writer->Close({}));

  EXPECT_FALSE(std::filesystem::exists(folder.path() / "run-2.mcap"));
  const auto before = Open("run-3.mcap");
  const auto last = Open("run-4.mcap");
  const auto third = MessagesOf(*before, "robot/arm/state/Count");
  const auto fourth = MessagesOf(*last, "robot/arm/state/Count");
  ASSERT_FALSE(third.empty());
  ASSERT_FALSE(fourth.empty());
  EXPECT_EQ(third.back().sequence + 1, fourth.front().sequence) << "no row is between two files";
  EXPECT_EQ(fourth.back().sequence, tick - 1);
  EXPECT_EQ(last->attachments().size(), 1U);
  const auto catalogue = MessagesOf(*last, kCatalogueTopic);
  ASSERT_EQ(catalogue.size(), 1U);
  EXPECT_EQ(ValueOf<CatalogueChange>(catalogue[0]).process, "robot");
}

TEST_F(RecordingWriterTest, NeverReplacesAFile) {
  folder.Write("run.mcap", "of somebody else");

  const auto writer = RecordingWriter::Create({.file = folder.path() / "run.mcap"}, {});

  ASSERT_FALSE(writer);
  EXPECT_EQ(writer.error().code, ErrorCode::kExists);
  EXPECT_EQ(folder.Read("run.mcap"), "of somebody else");
}

/// Returns one row of a table with 1000 columns. `epoch` is the run of its component.
RowsEntry WideRow(const std::shared_ptr<const EntrySource>& source, std::uint64_t epoch) {
  RowsEntry rows;
  rows.source = source;
  rows.epoch = epoch;
  rows.ticks = {0};
  rows.times = {static_cast<std::int64_t>(1'000'000 * epoch)};
  rows.cell_sizes.assign(source->members.size(), 1);
  rows.cells.assign(source->members.size(), std::byte{7});
  return rows;
}

std::shared_ptr<const EntrySource> WideTable() {
  auto source = std::make_shared<EntrySource>();
  source->name = {"robot", "crasher", "state"};
  for (int i = 0; i < 1000; ++i) {
    source->members.push_back({"C" + std::to_string(i), SchemaOf<std::uint8_t>()});
  }
  return source;
}

TEST_F(RecordingWriterTest, AComponentThatUsesUpTheChannelsIsRefusedAndTheOthersAreWritten) {
  const auto writer = Create();
  const auto wide = WideTable();
  ASSERT_TRUE(writer->Write(RowsOf(ArmTable(), 0, 1)));
  for (std::uint64_t epoch = 1; epoch <= 64; ++epoch) {
    ASSERT_TRUE(writer->Write(WideRow(wide, epoch))) << epoch;
  }

  for (std::uint64_t epoch = 65; epoch <= 67; ++epoch) {
    const auto written = writer->Write(WideRow(wide, epoch));
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::kInvalid);
    EXPECT_THAT(written.error().message, HasSubstr("has no room for robot/crasher/state"));
  }
  ASSERT_TRUE(writer->Write(RowsOf(ArmTable(), 1, 1)));
  EXPECT_EQ(writer->counts().rows, 66U);
  ASSERT_TRUE(writer->Close({}));
  EXPECT_EQ(MessagesOf(*Open(), "robot/arm/state/Count").size(), 2U);
}

TEST_F(RecordingWriterTest, ASplitBeginsAnotherFileBeforeTheChannelsAreUsedUp) {
  const auto writer = Create({.split_size = std::uint64_t{1} << 40U});
  const auto wide = WideTable();
  for (std::uint64_t epoch = 1; epoch <= 70; ++epoch) {
    ASSERT_TRUE(writer->Write(WideRow(wide, epoch))) << epoch;
  }
  EXPECT_EQ(writer->counts().files, 3U);
  EXPECT_EQ(writer->counts().rows, 70U);
  ASSERT_TRUE(writer->Close({}));
}

TEST_F(RecordingWriterTest, ASplitWithoutANextFileFailsUpToItsEnd) {
  FileOptions options{.compression = mcap::Compression::kNone,
                      .split_size = std::uint64_t{1} << 20U};
  options.create =
      [](const std::filesystem::path& path) -> Result<std::unique_ptr<os::WritableFile>> {
    if (path.filename() != "run-1.mcap") return Error{ErrorCode::kFailed, "no more files"};
    return os::CreateWritableFile(path);
  };
  const auto writer = Create(options);
  const auto table = ArmTable();
  Result<void> written;
  for (std::uint64_t tick = 0; written && tick < 1'000'000; tick += 1000) {
    written = writer->Write(RowsOf(table, tick, 1000));
  }
  ASSERT_FALSE(written) << "it never splits";

  const auto closed = writer->Close({});

  ASSERT_FALSE(closed);
  EXPECT_EQ(closed.error().message, "no more files");
  EXPECT_EQ(writer->losses().rows.at("robot/arm/state").viewer, 1000U);
  EXPECT_FALSE(MessagesOf(*Open("run-1.mcap"), "robot/arm/state/Count").empty());
}

TEST_F(RecordingWriterTest, AfterAFailureEverythingThatIsNotInTheFileIsCountedAsLost) {
  const auto disk = std::make_shared<test::MemoryDisk>();
  FileOptions options{.compression = mcap::Compression::kNone};
  options.create = [&](const auto&) -> Result<std::unique_ptr<os::WritableFile>> {
    return {std::make_unique<test::MemoryWritableFile>(disk)};
  };
  const auto writer = Create(options);
  const auto events = std::make_shared<EntrySource>();
  events->name = {"robot", "arm", "Control"};
  events->members = {{"Stopped", Schema()}};
  const auto commands = std::make_shared<EntrySource>();
  commands->name = events->name;
  commands->members = {{"Stop", SchemaOfCalls(Schema(), Schema())}};
  commands->are_commands = true;
  ASSERT_TRUE(writer->Write(RowsOf(ArmTable(), 0, 3)));
  ASSERT_TRUE(writer->Sync());
  disk->capacity = disk->bytes.size() + 20'000;  // there is room for the summary

  ASSERT_TRUE(writer->Write(RowsOf(ArmTable(), 3, 4)));
  ASSERT_TRUE(writer->Write(EventEntry{events, 0, SteadyClock().Now(), {}}));
  ASSERT_TRUE(writer->Write(EventEntry{commands, 0, SteadyClock().Now(), {}}));
  const std::string large(30'000, 'x');
  ASSERT_TRUE(writer->Write(LogEntry{{WallTime(), LogLevel::kInfo, "robot", "arm", large}}));
  EXPECT_EQ(writer->counts().rows, 7U);
  EXPECT_EQ(writer->counts().commands, 1U);
  EXPECT_EQ(writer->losses().all(), 0U);
  ASSERT_FALSE(writer->Sync());
  ASSERT_FALSE(writer->Write(RowsOf(ArmTable(), 7, 2)));

  EXPECT_EQ(writer->counts().rows, 3U);
  EXPECT_EQ(writer->counts().events, 0U);
  EXPECT_EQ(writer->counts().commands, 0U);
  EXPECT_EQ(writer->counts().log, 0U);
  const Losses losses = writer->losses();
  EXPECT_EQ(losses.rows.at("robot/arm/state").viewer, 6U);
  EXPECT_EQ(losses.events.at("robot/arm/Control.Stopped"), 1U);
  EXPECT_EQ(losses.events.at("robot/arm/Control.Stop"), 1U);
  EXPECT_EQ(losses.log, 1U);
  EXPECT_FALSE(writer->Close({}));
  const auto reader = mcap::Open(disk->bytes);
  EXPECT_FALSE(reader->was_scanned());
  std::map<std::string, std::string> told;
  for (const auto& index : reader->metadata()) {
    if (index.name == kEndMetadata) told = reader->ReadMetadata(index)->metadata;
  }
  EXPECT_EQ(told["rows"], "3");
  EXPECT_EQ(told["rows_lost_recorder"], "6");
  EXPECT_EQ(told["events_lost"], "2") << "the event and the call";
  EXPECT_EQ(told["log_records_lost"], "1");
}

}  // namespace
}  // namespace tendon::recording
