#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/folder.h>
#include <tendon/gcm/text.h>
#include <tendon/interface/observed_call.h>
#include <tendon/payload/codec.h>
#include <tendon/payload/json.h>
#include <tendon/payload/robot/geometry.h>
#include <tendon/payload/robot/image.h>
#include <tendon/payload/robot/joints.h>
#include <tendon/payload/robot/joystick.h>
#include <tendon/payload/robot/transforms.h>
#include <tendon/recording/channel_groups.h>
#include <tendon/recording/recording_writer.h>
#include <tests/core/payload/random_value.h>
#include <tests/core/payload/sample_types.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "oracle.h"
#include "recordings.h"

/// Compares files of Tendon with files of other programs, in both directions.
namespace tendon::recording {
namespace {

using nlohmann::json;
using testing::Contains;
using testing::Pair;

/// Runs the scripts in oracle/; skips the test if `tools/setup --oracles` has not installed their
/// packages.
class RecordingOracle : public testing::Test {
 protected:
  void SetUp() override {
    if (!HasOracle()) GTEST_SKIP() << kNoOracle;
  }
  [[nodiscard]] std::vector<json> Run(const std::string& script,
                                      const std::vector<std::string>& options = {}) const {
    return RunOracle(script, file_, options);
  }

  const test::Folder folder_;
  const std::filesystem::path file_ = folder_.path() / "run.mcap";
};

/// Returns a number as the script prints it.
json NumberTruth(double number) {
  if (std::isnan(number)) return "NaN";
  if (std::isinf(number)) return number > 0 ? "Infinity" : "-Infinity";
  if (number == 0 && std::signbit(number)) return "-0";
  return number;
}

/// Returns a value as the script prints it. It is made from the members of the C++ type, not from
/// its bytes.
template <typename T>
json Truth(const T& value);

/// Appends the numbers of nested arrays in one list, because ROS 2 has no arrays of arrays.
template <typename T>
void AppendTruth(const T& value, json::array_t& list) {
  if constexpr (payload::Array<T>) {
    for (const auto& element : value) AppendTruth(element, list);
  } else {
    list.push_back(Truth(value));
  }
}

template <typename T>
json Truth(const T& value) {
  if constexpr (std::same_as<T, std::byte>) {
    return std::to_integer<int>(value);
  } else if constexpr (std::same_as<T, bool>) {
    return value;
  } else if constexpr (std::is_floating_point_v<T>) {
    return NumberTruth(value);
  } else if constexpr (payload::Number<T>) {
    if constexpr (sizeof(T) == 8) return std::to_string(value);
    return static_cast<std::int64_t>(value);
  } else if constexpr (payload::Enum<T>) {
    return static_cast<std::int32_t>(value);
  } else if constexpr (payload::Text<T>) {
    return value;
  } else if constexpr (payload::TimeSpan<T>) {
    const auto seconds = std::chrono::floor<std::chrono::seconds>(value);
    return {{"sec", seconds.count()}, {"nsec", std::chrono::nanoseconds(value - seconds).count()}};
  } else if constexpr (requires { value.time_since_epoch(); }) {
    return Truth(value.time_since_epoch());
  } else if constexpr (payload::Array<T>) {
    json::array_t list;
    AppendTruth(value, list);
    return list;
  } else if constexpr (payload::Sequence<T>) {
    using Item = payload::ItemOf<T>;
    json::array_t list;
    for (const Item& element : value) {
      if constexpr (payload::Array<Item> || payload::Sequence<Item>) {
        // ROS 2 has no sequences of lists, so each inner list is a separate message.
        list.push_back(json::object_t{{"data", Truth(element)}});
      } else {
        list.push_back(Truth(element));
      }
    }
    return list;
  } else {
    json::object_t object;
    payload::WithFields<T>([&](const auto&... field) {
      ((object[std::string(field.name)] = Truth(value.*field.member)), ...);
    });
    return object;
  }
}

/// A column that is not a structure becomes a message with the single field `data`.
template <typename T>
json MessageTruth(const T& value) {
  if constexpr (payload::Structure<T>) return Truth(value);
  return {{"data", Truth(value)}};
}

/// Rows with a column of each kind of payload, and their expected contents.
class TableWithTruth {
 public:
  TableWithTruth() {
    source_->name = {"robot", "arm", "state"};
    AddRow({}, 0);  // defines the names of the columns
    rows_ = {};
    truth_.clear();
  }

  void AddRows(std::uint64_t first, std::size_t count) {
    rows_ = {.source = source_, .epoch = 3};
    const std::int64_t now = SteadyClock().Now().time_since_epoch().count();
    for (std::uint64_t tick = first; tick < first + count; ++tick) {
      rows_.ticks.push_back(tick);
      rows_.times.push_back(now + static_cast<std::int64_t>(tick - first) * 1'000'000);
      AddRow(ValueOf(tick), tick);
    }
  }
  [[nodiscard]] const RowsEntry& rows() const { return rows_; }
  /// Returns the expected messages, without their log time. The key "source_time" replaces it.
  [[nodiscard]] const std::vector<json>& truth() const { return truth_; }

 private:
  struct Values {
    sample::Numbers numbers;
    sample::Fixed fixed;
    sample::Dynamic dynamic;
    sample::JointState joints;
    double number = 0.0;
    std::uint64_t count = 0;
    std::string text;
    std::vector<float> samples;
    sample::Mode mode = sample::Mode::kOff;
    std::chrono::nanoseconds span{0};
    std::vector<std::vector<std::int64_t>> lists;
    bool flag = false;
    robot::Pose pose;
    robot::Twist twist;
    robot::Wrench wrench;
    robot::JointState<7> arm_state;
    robot::JointCommand<7> arm_command;
    robot::NamedJointState named_joints;
    robot::Joystick joystick;
    robot::Image image;
    robot::Transforms transforms;
  };

  /// Returns random values; extreme values for the first rows.
  Values ValueOf(std::uint64_t tick) {
    using Doubles = std::numeric_limits<double>;
    using Floats = std::numeric_limits<float>;
    constexpr double kNumbers[] = {0.0,
                                   -0.0,
                                   Doubles::infinity(),
                                   -Doubles::infinity(),
                                   Doubles::quiet_NaN(),
                                   Doubles::max(),
                                   Doubles::denorm_min(),
                                   0.1};
    Values values;
    sample::Randomise(random_, values.numbers);
    sample::Randomise(random_, values.fixed);
    sample::Randomise(random_, values.dynamic);
    sample::Randomise(random_, values.joints);
    sample::Randomise(random_, values.count);
    sample::Randomise(random_, values.text);
    sample::Randomise(random_, values.samples);
    sample::Randomise(random_, values.mode);
    sample::Randomise(random_, values.span);
    sample::Randomise(random_, values.lists);
    sample::Randomise(random_, values.pose);
    sample::Randomise(random_, values.twist);
    sample::Randomise(random_, values.wrench);
    sample::Randomise(random_, values.arm_state);
    sample::Randomise(random_, values.arm_command);
    sample::Randomise(random_, values.named_joints);
    sample::Randomise(random_, values.joystick);
    sample::Randomise(random_, values.image);
    sample::Randomise(random_, values.transforms);
    values.number = kNumbers[tick % std::size(kNumbers)];
    values.joints.position[2] = values.number;
    values.numbers.f32 = static_cast<float>(values.numbers.f64);
    if (tick == 1) values.samples = {Floats::infinity(), -0.0F, Floats::denorm_min(), 0.1F};
    if (tick == 2) values.count = std::numeric_limits<std::uint64_t>::max();
    if (tick == 2) values.numbers.i64 = std::numeric_limits<std::int64_t>::min();
    if (tick == 3) values.text = "größer: 5 µm, \"quoted\"\n\t\\ 漢字 🤖";
    values.flag = tick % 2 == 1;
    return values;
  }

  void AddRow(const Values& values, std::uint64_t tick) {
    Add("Numbers", values.numbers, tick);
    Add("Fixed", values.fixed, tick);
    Add("Dynamic", values.dynamic, tick);
    Add("Joints", values.joints, tick);
    Add("Number", values.number, tick);
    Add("Count", values.count, tick);
    Add("Text", values.text, tick);
    Add("Samples", values.samples, tick);
    Add("Mode", values.mode, tick);
    Add("Span", values.span, tick);
    Add("Lists", values.lists, tick);
    Add("Flag", values.flag, tick);
    Add("Pose", values.pose, tick);
    Add("Twist", values.twist, tick);
    Add("Wrench", values.wrench, tick);
    Add("ArmState", values.arm_state, tick);
    Add("ArmCommand", values.arm_command, tick);
    Add("NamedJoints", values.named_joints, tick);
    Add("Joystick", values.joystick, tick);
    Add("Image", values.image, tick);
    Add("Transforms", values.transforms, tick);
  }

  template <typename T>
  void Add(const std::string& name, const T& value, std::uint64_t tick) {
    if (source_->members.size() < kColumns) source_->members.push_back({name, SchemaOf<T>()});
    std::vector<std::byte> cell;
    Encode(value, cell);
    rows_.cell_sizes.push_back(static_cast<std::uint32_t>(cell.size()));
    rows_.cells.insert(rows_.cells.end(), cell.begin(), cell.end());
    truth_.push_back({{"kind", "message"},
                      {"topic", "robot/arm/state/" + name},
                      {"schema", RosTypeName(SchemaOf<T>())},
                      {"sequence", tick},
                      {"source_time", rows_.times.empty() ? 0 : rows_.times.back()},
                      {"value", MessageTruth(value)}});
  }

  static constexpr std::size_t kColumns = 21;

  const std::shared_ptr<EntrySource> source_ = std::make_shared<EntrySource>();
  std::mt19937 random_{22};
  RowsEntry rows_;
  std::vector<json> truth_;
};

class DecodedByAnOracle : public RecordingOracle,
                          public testing::WithParamInterface<mcap::Compression> {
 protected:
  std::unique_ptr<RecordingWriter> Create() {
    auto writer = RecordingWriter::Create({.file = file_, .compression = GetParam()},
                                          {{{"paths", "robot/**"}}, R"({"version": 1})"});
    EXPECT_TRUE(writer) << writer.error().message;
    return *std::move(writer);
  }
  /// Returns all metadata by name.
  static std::map<std::string, json> MetadataOf(const std::vector<json>& lines) {
    std::map<std::string, json> all;
    for (const json& line : OfKind(lines, "metadata")) all[line["name"]] = line["metadata"];
    return all;
  }
};

std::string NameOfCompression(const testing::TestParamInfo<mcap::Compression>& compression) {
  return std::string(mcap::NameOf(compression.param));
}

INSTANTIATE_TEST_SUITE_P(, DecodedByAnOracle,
                         testing::Values(mcap::Compression::kNone, mcap::Compression::kLz4,
                                         mcap::Compression::kZstd),
                         NameOfCompression);

TEST_P(DecodedByAnOracle, EveryValueOfEveryKindOfPayloadIsTheOneThatWasRecorded) {
  TableWithTruth table;
  table.AddRows(0, 300);
  const auto writer = Create();
  ASSERT_TRUE(writer->Write(table.rows()));
  ASSERT_TRUE(writer->Close({}));

  const auto lines = Run("decode.mjs");

  auto found = ByTopic(OfKind(lines, "message"));
  auto metadata = MetadataOf(lines);
  const std::int64_t shift =
      std::stoll(metadata[kAboutMetadata]["wall_minus_steady_ns"].get<std::string>());
  std::map<std::string, std::size_t> next;
  for (json expected : table.truth()) {
    const std::string topic = expected["topic"];
    const std::int64_t time = expected["source_time"].get<std::int64_t>() + shift;
    expected.erase("source_time");
    expected["log_time"] = expected["publish_time"] = std::to_string(time);
    const std::size_t index = next[topic]++;
    ASSERT_LT(index, found[topic].size()) << topic;
    ASSERT_EQ(found[topic][index], expected) << topic;
  }
  for (const auto& [topic, messages] : found) EXPECT_EQ(messages.size(), next[topic]) << topic;
  EXPECT_EQ(OfKind(lines, "statistics").at(0)["messages"], std::to_string(table.truth().size()));
}

TEST_P(DecodedByAnOracle, EventsTheLogLossesAndTheCatalogueAreThoseThatWereRecorded) {
  auto source = std::make_shared<EntrySource>();
  source->name = {"robot", "arm", "Control"};
  source->members = {{"Stopped", Schema()}, {"Moved", SchemaOf<sample::Ragged>()}};
  const sample::Ragged moved{true, -2.5, 200, -3, false, 0.5F, 9};
  std::vector<std::byte> value;
  Encode(moved, value);
  const SteadyTime raised = SteadyClock().Now();
  const CatalogueChange change{.revision = 1,
                               .kind = CatalogueChange::Kind::kProcess,
                               .process = "robot",
                               .processes = {{.name = "robot", .instance = 7}}};
  const auto writer = Create();
  const std::int64_t logged = WallTime();
  ASSERT_TRUE(writer->Write(CatalogueEntry{true, raised, {change}}));
  ASSERT_TRUE(writer->Write(EventEntry{source, 0, raised, {}}));
  ASSERT_TRUE(writer->Write(EventEntry{source, 1, raised, value}));
  ASSERT_TRUE(
      writer->Write(LogEntry{{logged, LogLevel::kWarning, "robot", "arm", "too warm: 90 °C"}}));
  ASSERT_TRUE(writer->WriteLoss("robot/arm/state", {1, 2, 5}));
  ASSERT_TRUE(writer->Close({.rows = {{"robot/arm/state", {1, 2, 5}}}, .events = {}, .log = 0}));

  const auto lines = Run("decode.mjs");

  auto found = ByTopic(OfKind(lines, "message"));
  EXPECT_EQ(found["robot/arm/Control/Stopped"].at(0)["value"], json::object());
  EXPECT_EQ(found["robot/arm/Control/Moved"].at(0)["value"], Truth(moved));
  EXPECT_EQ(found[kLogTopic].at(0)["value"],
            (json{{"stamp", Truth(std::chrono::nanoseconds(logged))},
                  {"level", 30},
                  {"name", "robot/arm"},
                  {"msg", "too warm: 90 °C"},
                  {"file", ""},
                  {"function", ""},
                  {"line", 0}}));
  EXPECT_EQ(found[kLogTopic].at(0)["schema"], "rcl_interfaces/msg/Log");
  EXPECT_EQ(
      found[kLossTopic].at(0)["value"],
      (json{{"path", "robot/arm/state"}, {"table", "1"}, {"network", "2"}, {"recorder", "5"}}));
  EXPECT_EQ(found[kCatalogueTopic].at(0)["value"]["process"], "robot");
  EXPECT_EQ(found[kCatalogueTopic].at(0)["value"]["processes"][0]["instance"], "7");
  EXPECT_THAT(MetadataOf(lines), Contains(Pair(kEndMetadata, Contains("2"))));
  EXPECT_EQ(OfKind(lines, "attachment").at(0)["name"], kSystemAttachment);
}

TEST_P(DecodedByAnOracle, CallsOfCommandsAreThoseThatWereRecorded) {
  auto source = std::make_shared<EntrySource>();
  source->name = {"robot", "arm", "Control"};
  source->are_commands = true;
  source->members = {{"Stop", SchemaOfCalls(SchemaOf<None>(), SchemaOf<None>())},
                     {"Plan", SchemaOfCalls(SchemaOf<sample::Ragged>(), SchemaOf<std::string>())}};
  const CallHeader refused{.outcome = CallOutcome::kRefused, .status = Status::kQueueFull};
  const CallHeader executed{.took = std::chrono::nanoseconds(1'000'000'250)};
  const sample::Ragged argument{true, -2.5, 200, -3, false, 0.5F, 9};
  const std::string result = "to 2.5 rad";
  const std::string client = "desk/pilot/Arm";
  const auto body_of = [](const ArgumentWriter& call) {
    const auto bytes = call.Encoded();
    return std::vector<std::byte>(bytes.begin(), bytes.end());
  };
  const None none;
  const SteadyTime ended = SteadyClock().Now();
  const auto writer = Create();
  ASSERT_TRUE(writer->Write(EventEntry{
      source, 0, ended, body_of(ObservedCallWriter<None, None>(refused, none, nullptr, client))}));
  ASSERT_TRUE(writer->Write(EventEntry{source, 1, ended,
                                       body_of(ObservedCallWriter<sample::Ragged, std::string>(
                                           executed, argument, &result, client))}));
  ASSERT_TRUE(writer->Close({}));

  const auto lines = Run("decode.mjs");

  auto found = ByTopic(OfKind(lines, "message"));
  const json& stop = found["robot/arm/Control/Stop"].at(0);
  const json& plan = found["robot/arm/Control/Plan"].at(0);
  EXPECT_EQ(stop["value"], (json{{"took", Truth(refused.took)},
                                 {"outcome", Truth(refused.outcome)},
                                 {"status", Truth(refused.status)},
                                 {"client", client}}));
  EXPECT_EQ(plan["value"], (json{{"took", Truth(executed.took)},
                                 {"outcome", Truth(executed.outcome)},
                                 {"status", Truth(executed.status)},
                                 {"argument", Truth(argument)},
                                 {"result", result},
                                 {"client", client}}));
  const auto time_of = [](const json& message) {
    return std::stoll(message["log_time"].get<std::string>());
  };
  EXPECT_EQ(time_of(stop) - time_of(plan), executed.took.count())
      << "the time of a call is that of its begin";
}

/// Returns lower-case hexadecimal digits, two for each byte.
std::string HexOf(mcap::ByteView bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const std::byte byte : bytes) {
    text += kDigits[std::to_integer<std::size_t>(byte >> 4)];
    text += kDigits[std::to_integer<std::size_t>(byte & std::byte{15})];
  }
  return text;
}

/// Returns everything that Tendon's reader finds, in the format of write.mjs.
std::vector<json> ContentsOf(mcap::Reader& reader) {
  std::vector<json> all;
  for (const auto& [id, channel] : reader.channels()) {
    const auto schema = reader.schemas().find(channel.schema_id);
    const bool has_schema = schema != reader.schemas().end();
    all.push_back({{"kind", "channel"},
                   {"topic", channel.topic},
                   {"encoding", channel.message_encoding},
                   {"metadata", channel.metadata},
                   {"schema", has_schema ? schema->second.name : ""},
                   {"definition", has_schema ? HexOf(mcap::BytesOf(schema->second.data)) : ""}});
  }
  for (const auto& index : reader.attachments()) {
    const auto attachment = reader.ReadAttachment(index);
    if (!attachment) continue;
    all.push_back({{"kind", "attachment"},
                   {"name", attachment->name},
                   {"media_type", attachment->media_type},
                   {"log_time", std::to_string(attachment->log_time)},
                   {"create_time", std::to_string(attachment->create_time)},
                   {"data", HexOf(attachment->data)}});
  }
  for (const auto& index : reader.metadata()) {
    const auto metadata = reader.ReadMetadata(index);
    if (!metadata) continue;
    all.push_back(
        {{"kind", "metadata"}, {"name", metadata->name}, {"metadata", metadata->metadata}});
  }
  for (const auto& message : mcap::ReadAll(reader, {.order = mcap::Query::Order::kFile})) {
    all.push_back({{"kind", "message"},
                   {"topic", message.topic},
                   {"sequence", message.sequence},
                   {"log_time", std::to_string(message.log_time)},
                   {"publish_time", std::to_string(message.publish_time)},
                   {"data", HexOf(mcap::BytesOf(message.data))}});
  }
  return all;
}

/// The way in which an oracle writes a file.
struct Writing {
  const char* name;
  const char* options;  // options of write.mjs
};

class WrittenByAnOracle : public RecordingOracle, public testing::WithParamInterface<Writing> {};

constexpr const char* kWithoutSummary = R"({"compression": "zstd", "useStatistics": false,
  "useSummaryOffsets": false, "repeatSchemas": false, "repeatChannels": false,
  "useAttachmentIndex": false, "useMetadataIndex": false, "useMessageIndex": false,
  "useChunkIndex": false})";

INSTANTIATE_TEST_SUITE_P(
    , WrittenByAnOracle,
    testing::Values(Writing{"uncompressed", R"({"compression": "none"})"},
                    Writing{"zstd", R"({"compression": "zstd"})"},
                    Writing{"lz4", R"({"compression": "lz4"})"},
                    Writing{"without_chunks", R"({"useChunks": false})"},
                    Writing{"without_an_index", R"({"compression": "lz4", "useMessageIndex": false,
                                                    "useChunkIndex": false})"},
                    Writing{"without_message_indexes", R"({"useMessageIndex": false})"},
                    Writing{"without_attachment_index", R"({"useAttachmentIndex": false,
                                                            "useMetadataIndex": false})"},
                    Writing{"without_summary", kWithoutSummary}),
    [](const testing::TestParamInfo<Writing>& writing) { return std::string(writing.param.name); });

TEST_P(WrittenByAnOracle, AFileHasTheContentThatWasWritten) {
  const auto written = Run("write.mjs", {GetParam().options});

  const auto reader = mcap::Reader::Open(file_);

  ASSERT_TRUE(reader) << reader.error().message;
  const auto found = ContentsOf(**reader);
  for (const char* kind : {"channel", "attachment", "metadata", "message"}) {
    const auto expected = OfKind(written, kind);
    EXPECT_FALSE(expected.empty()) << kind;
    EXPECT_EQ(OfKind(found, kind), expected) << kind;
  }
  EXPECT_EQ((*reader)->header(), (mcap::Header{"ros2", "oracle"}));
}

TEST_P(WrittenByAnOracle, AFileReadsInOrderOfTime) {
  auto expected = OfKind(Run("write.mjs", {GetParam().options}), "message");
  std::ranges::stable_sort(expected, {}, [](const json& message) {
    return std::stoull(message["log_time"].get<std::string>());
  });

  const auto reader = mcap::Reader::Open(file_);

  ASSERT_TRUE(reader) << reader.error().message;
  const auto found = mcap::ReadAll(**reader);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(std::to_string(found[i].log_time), expected[i]["log_time"]) << i;
    ASSERT_EQ(HexOf(mcap::BytesOf(found[i].data)), expected[i]["data"]) << i;
  }
}

class RosMessagesOfAnOracle : public RecordingOracle {};

TEST_F(RosMessagesOfAnOracle, AreReadByTheirDefinitions) {
  const auto written = Run("write_ros.mjs");

  const auto reader = mcap::Reader::Open(file_);

  ASSERT_TRUE(reader) << reader.error().message;
  std::size_t count = 0;
  RosTypes known;
  mcap::MessageStream messages = (*reader)->Messages({.order = mcap::Query::Order::kFile});
  while (const auto message = messages.Next()) {
    ASSERT_LT(count, written.size());
    const json& expected = written[count++];
    const mcap::Channel& channel = *(*reader)->FindChannel(message->channel_id);
    ASSERT_EQ(channel.topic, expected["topic"]);
    const auto member = MemberOf(**reader, channel, known);
    ASSERT_TRUE(member) << member.error().message;
    const auto found = ToJson(member->schema, BodyOf(message->data));
    ASSERT_TRUE(found) << found.error().message;
    ASSERT_EQ(json::parse(*found), expected["value"]) << count;
  }
  EXPECT_EQ(count, written.size());
  EXPECT_GT(count, 50U);
}

}  // namespace
}  // namespace tendon::recording
