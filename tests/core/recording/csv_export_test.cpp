#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/folder.h>
#include <sys/resource.h>
#include <tendon/base/os/part_file.h>
#include <tendon/gcm/text.h>
#include <tendon/payload/codec.h>
#include <tendon/recording/csv_export.h>
#include <tendon/recording/recording_writer.h>
#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "recordings.h"

namespace tendon::recording {

struct Wheel {
  double speed = 0.0;
  std::string note;
};

}  // namespace tendon::recording

template <>
inline constexpr auto tendon::kPayload<tendon::recording::Wheel> = tendon::Describe(
    "cart.Wheel", tendon::Field{"speed", &tendon::recording::Wheel::speed, "rad/s"},
    tendon::Field{"note", &tendon::recording::Wheel::note});

namespace tendon::recording {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

std::shared_ptr<const EntrySource> CartTable() {
  auto source = std::make_shared<EntrySource>();
  source->name = {"robot", "cart", "state"};
  source->members = {{"Wheel", SchemaOf<Wheel>()}, {"Count", SchemaOf<std::uint64_t>()}};
  return source;
}

/// Returns a batch of one row.
RowsEntry RowOf(std::uint64_t tick, const Wheel& wheel, std::uint64_t epoch = 1) {
  RowsEntry rows{.source = CartTable(), .epoch = epoch};
  rows.ticks = {tick};
  rows.times = {static_cast<std::int64_t>(1000 * tick)};
  Encode(wheel, rows.cells);
  rows.cell_sizes = {static_cast<std::uint32_t>(rows.cells.size())};
  std::vector<std::byte> count;
  Encode(tick, count);
  rows.cells.insert(rows.cells.end(), count.begin(), count.end());
  rows.cell_sizes.push_back(8);
  return rows;
}

class CsvExport : public testing::Test {
 protected:
  void SetUp() override {
    auto created = RecordingWriter::Create({.file = file}, {});
    ASSERT_TRUE(created) << created.error().message;
    files = *std::move(created);
  }
  Result<CsvReport> Export(const mcap::Query& query = {}) {
    EXPECT_TRUE(files->Close({}));
    reader = *mcap::Reader::Open(file);
    return ExportCsv(*reader, query, folder.path() / "csv");
  }
  /// Returns the lines of a file without the two times, because the test knows only one of them.
  std::vector<std::string> Lines(const std::string& name) const {
    std::istringstream all(folder.Read("csv/" + name));
    std::vector<std::string> lines;
    for (std::string line; std::getline(all, line);) {
      lines.push_back(line.substr(line.find(',') + 1));
    }
    return lines;
  }

  const test::Folder folder;
  const std::filesystem::path file = folder.path() / "run.mcap";
  std::unique_ptr<RecordingWriter> files;
  std::unique_ptr<mcap::Reader> reader;
};

TEST_F(CsvExport, ATableIsAFileWithAColumnForEachNumber) {
  ASSERT_TRUE(files->Write(RowOf(7, {0.1 + 0.2, "say \"hi\", twice"})));
  ASSERT_TRUE(files->Write(RowOf(8, {std::numeric_limits<double>::quiet_NaN(), ""})));

  const auto report = Export();

  ASSERT_TRUE(report) << report.error().message;
  EXPECT_THAT(report->files, ElementsAre(folder.path() / "csv" / "robot.cart.state.csv"));
  EXPECT_EQ(report->rows, 2U);
  EXPECT_THAT(Lines("robot.cart.state.csv"),
              ElementsAre("source_time_ns,sequence,lost,Wheel.speed,Wheel,Count",
                          "7000,7,0,0.30000000000000004,"
                          R"("{""speed"":0.30000000000000004,""note"":""say \""hi\"", twice""}",7)",
                          R"(8000,8,0,nan,"{""speed"":""nan"",""note"":""""}",8)"));
}

TEST_F(CsvExport, MissingRowsAreARowThatSaysHowMany) {
  for (const std::uint64_t tick : {3, 4, 9}) ASSERT_TRUE(files->Write(RowOf(tick, {})));

  const auto report = Export();

  ASSERT_TRUE(report);
  EXPECT_EQ(report->lost, 4U);
  const auto lines = Lines("robot.cart.state.csv");
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[3], ",,4,,,");
  EXPECT_THAT(lines[4], testing::StartsWith("9000,9,0,"));
}

TEST_F(CsvExport, ARestartOfTheSourceIsNoLossAndHasTheSameFile) {
  ASSERT_TRUE(files->Write(RowOf(500, {}, 1)));
  ASSERT_TRUE(files->Write(RowOf(0, {}, 2)));
  ASSERT_TRUE(files->Write(RowOf(1, {}, 2)));

  const auto report = Export();

  ASSERT_TRUE(report);
  EXPECT_EQ(report->files.size(), 1U);
  EXPECT_EQ(report->rows, 3U);
  EXPECT_EQ(report->lost, 0U);
}

TEST_F(CsvExport, AnEventIsAFileOfItsOwn) {
  auto source = std::make_shared<EntrySource>();
  source->name = {"robot", "cart", "Control"};
  source->members = {{"Stopped", Schema()}, {"Passed", SchemaOf<double>()}};
  std::vector<std::byte> value;
  Encode(1.5, value);
  ASSERT_TRUE(files->Write(EventEntry{source, 0, SteadyClock().Now(), {}}));
  ASSERT_TRUE(files->Write(EventEntry{source, 1, SteadyClock().Now(), value}));

  const auto report = Export();

  ASSERT_TRUE(report);
  const auto passed = Lines("robot.cart.Control.Passed.csv");
  ASSERT_EQ(passed.size(), 2U);
  EXPECT_EQ(passed[0], "source_time_ns,sequence,lost,value");
  EXPECT_THAT(passed[1], testing::EndsWith(",0,0,1.5"));
  EXPECT_EQ(Lines("robot.cart.Control.Stopped.csv").size(), 2U);
}

TEST_F(CsvExport, RecordsOfTheLogThatCameLateAreNoLoss) {
  const std::int64_t now = WallTime() + 1'000'000'000;
  for (const std::int64_t later : {5, 3, 9}) {
    ASSERT_TRUE(files->Write(LogEntry{{now + later, LogLevel::kInfo, "robot", "cart", "text"}}));
  }

  const auto report = Export();

  ASSERT_TRUE(report);
  EXPECT_EQ(report->log, 3U);
  EXPECT_EQ(report->rows, 0U);
  EXPECT_EQ(report->lost, 0U);
}

TEST_F(CsvExport, CountsRowsEventsTheLogAndOtherMessagesApart) {
  auto source = std::make_shared<EntrySource>();
  source->name = {"robot", "cart", "Control"};
  source->members = {{"Stopped", Schema()}};
  const CatalogueChange change{
      .revision = 1, .kind = CatalogueChange::Kind::kProcess, .process = "robot"};
  ASSERT_TRUE(files->Write(RowOf(1, {})));
  ASSERT_TRUE(files->Write(RowOf(2, {})));
  ASSERT_TRUE(files->Write(EventEntry{source, 0, SteadyClock().Now(), {}}));
  ASSERT_TRUE(files->Write(
      LogEntry{{WallTime() + 1'000'000'000, LogLevel::kInfo, "robot", "cart", "text"}}));
  ASSERT_TRUE(files->Write(CatalogueEntry{true, SteadyClock().Now(), {change}}));

  const auto report = Export();

  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->rows, 2U);
  EXPECT_EQ(report->events, 1U);
  EXPECT_EQ(report->log, 1U);
  EXPECT_EQ(report->others, 1U) << "of the catalogue";
  EXPECT_EQ(report->incomplete, 0U);
}

TEST_F(CsvExport, AnExportThatIsStoppedLeavesNoFile) {
  for (std::uint64_t tick = 0; tick < 2000; ++tick) ASSERT_TRUE(files->Write(RowOf(tick, {})));
  ASSERT_TRUE(files->Close({}));
  reader = *mcap::Reader::Open(file);

  const auto report = ExportCsv(*reader, {}, folder.path() / "csv", [] { return true; });

  ASSERT_FALSE(report);
  EXPECT_THAT(report.error().message, HasSubstr("no file was written"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "csv"));
}

TEST_F(CsvExport, AFolderThatCannotBeMadeIsNamed) {
  ASSERT_TRUE(files->Write(RowOf(1, {})));
  folder.Write("file", "");
  ASSERT_TRUE(files->Close({}));
  reader = *mcap::Reader::Open(file);

  const auto report = ExportCsv(*reader, {}, folder.path() / "file" / "csv");

  ASSERT_FALSE(report);
  EXPECT_THAT(report.error().message, HasSubstr("cannot create"));
}

TEST_F(CsvExport, ReplacesNoFile) {
  ASSERT_TRUE(files->Write(RowOf(1, {})));
  std::filesystem::create_directory(folder.path() / "csv");
  folder.Write("csv/robot.cart.state.csv", "of somebody else");

  const auto report = Export();

  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, ErrorCode::kExists);
  EXPECT_EQ(folder.Read("csv/robot.cart.state.csv"), "of somebody else");
}

/// A message that starts as ROS 2 writes it.
std::string Encapsulated(const std::string& body, char byte_order = 1) {
  return std::string({0, byte_order, 0, 0}) + body;
}

/// "rows 8 bytes": a double.
std::string BytesOfDouble(double number) {
  std::string text(sizeof number, 0);
  std::memcpy(text.data(), &number, sizeof number);
  return text;
}

/// A file of another program.
class CsvExportOfOthers : public testing::Test {
 protected:
  mcap::ChannelId AddChannel(const std::string& topic, const std::string& text,
                             const std::string& encoding = "cdr",
                             const std::string& schema_encoding = "ros2msg") {
    const auto schema = *recording.writer->AddSchema("a/msg/B", schema_encoding, text);
    return *recording.writer->AddChannel(schema, topic, encoding);
  }
  void Write(mcap::ChannelId channel, const std::string& data) {
    ++time;
    EXPECT_TRUE(recording.writer->Write(
        mcap::Message{channel, static_cast<std::uint32_t>(time), time, time, mcap::BytesOf(data)}));
  }
  Result<CsvReport> Export() {
    EXPECT_TRUE(recording.writer->Close());
    reader = mcap::Open(recording.disk->bytes);
    return ExportCsv(*reader, {}, folder.path() / "csv");
  }

  const test::Folder folder;
  mcap::MemoryRecording recording;
  mcap::Timestamp time = 0;
  std::unique_ptr<mcap::Reader> reader;
};

TEST_F(CsvExportOfOthers, TopicsOfRosAreExportedByTheirMessageDefinitions) {
  const auto pose = AddChannel("/arm/pose",
                               "Point[2] points\nbuiltin_interfaces/Time stamp\nstring name\n"
                               "===\nMSG: a/Point\nfloat64 x\n");
  using namespace std::string_literals;
  Write(pose,
        Encapsulated(BytesOfDouble(0.5) + BytesOfDouble(-2.0) + "\7\0\0\0\xA0\0\0\0\3\0\0\0ab\0"s));

  const auto report = Export();

  ASSERT_TRUE(report) << report.error().message;
  EXPECT_THAT(report->files, ElementsAre(folder.path() / "csv" / "arm.pose.csv"));
  EXPECT_EQ(report->others, 1U);
  EXPECT_THAT(folder.Read("csv/arm.pose.csv"),
              testing::StartsWith(
                  "time_ns,source_time_ns,sequence,lost,points[0].x,points[1].x,stamp,value\n"
                  "1,1,1,0,0.5,-2,7.00000016"));
  EXPECT_THAT(folder.Read("csv/arm.pose.csv"), HasSubstr(R"(""name"":""ab"")"));
}

TEST_F(CsvExportOfOthers, OtherEncodingsAreLeftOutWithTheReason) {
  const auto good = AddChannel("/good", "float64 x\n");
  const auto json = AddChannel("/json", "{}", "json", "jsonschema");
  const auto broken = AddChannel("/broken", "Missing x\n");
  Write(good, Encapsulated(BytesOfDouble(1.5)));
  for (int i = 0; i < 3; ++i) Write(json, "{}");
  Write(broken, Encapsulated(BytesOfDouble(1.5)));

  const auto report = Export();

  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->others, 1U);
  EXPECT_THAT(report->left_out,
              ElementsAre(Pair("their encoding is 'json' with a schema in 'jsonschema', and only "
                               "'cdr' with a schema in 'ros2msg' is read",
                               3U),
                          Pair(HasSubstr("the definition of 'Missing' is missing"), 1U)));
}

TEST_F(CsvExportOfOthers, AValueThatDoesNotFitItsTypeHasEmptyCellsAndIsCounted) {
  const auto channel = AddChannel("/x", "float64 x\n");
  Write(channel, Encapsulated(BytesOfDouble(1.5)));
  Write(channel, Encapsulated(BytesOfDouble(1.5), 0));            // big-endian
  Write(channel, Encapsulated("1234567"));                        // too short
  Write(channel, Encapsulated(BytesOfDouble(1.5) + "12345678"));  // too long
  Write(channel, "");

  const auto report = Export();

  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->others, 5U);
  EXPECT_EQ(report->incomplete, 4U);
  EXPECT_EQ(folder.Read("csv/x.csv"),
            "time_ns,source_time_ns,sequence,lost,x\n"
            "1,1,1,0,1.5\n2,2,2,0,\n3,3,3,0,\n4,4,4,0,\n5,5,5,0,\n");
}

TEST_F(CsvExportOfOthers, AnArrayWithMoreNumbersThanColumnsIsAlsoThereAsJson) {
  Write(AddChannel("/large", "uint8[16385] x\n"), Encapsulated(std::string(16384, 1) + '\7'));

  const auto report = Export();

  ASSERT_TRUE(report) << report.error().message;
  const std::string text = folder.Read("csv/large.csv");
  EXPECT_THAT(text, HasSubstr(",x[16383],value\n"));
  EXPECT_THAT(text, testing::EndsWith(",1,1,7]}\"\n"));
}

/// Lowers a limit of this process until the end of the scope.
class Limit {
 public:
  using Resource = decltype(RLIMIT_NOFILE);

  Limit(Resource resource, rlim_t value) : resource_(resource) {
    getrlimit(resource_, &before_);
    const rlimit tight{value, before_.rlim_max};
    setrlimit(resource_, &tight);
  }
  Limit(const Limit&) = delete;
  Limit& operator=(const Limit&) = delete;
  ~Limit() { setrlimit(resource_, &before_); }

 private:
  const Resource resource_;
  rlimit before_{};
};

/// Returns the limit with which this process can open `more` files.
rlim_t OpenFiles(rlim_t more) {
  const int lowest_free = dup(0);
  close(lowest_free);
  return static_cast<rlim_t>(lowest_free) + more;
}

TEST_F(CsvExportOfOthers, TooManyOpenFilesNameTheWayOut) {
  for (const char* topic : {"/a", "/b", "/c"}) {
    Write(AddChannel(topic, "uint8 x\n"), Encapsulated("1"));
  }
  ASSERT_TRUE(recording.writer->Close());
  reader = mcap::Open(recording.disk->bytes);
  const Limit limit(RLIMIT_NOFILE, OpenFiles(2));

  const auto report = ExportCsv(*reader, {}, folder.path() / "csv");

  ASSERT_FALSE(report);
  EXPECT_THAT(report.error().message, HasSubstr(".csv.part: Too many open files"));
  EXPECT_THAT(report.error().message, HasSubstr("ulimit -n"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "csv"));
}

/// A recording with more topics than an export keeps files open.
class CsvExportOfManyTables : public CsvExportOfOthers {
 protected:
  static constexpr std::size_t kTables = 120;
  static constexpr std::size_t kLargeText = 70'000;  // is written to the file at once

  void SetUp() override {
    for (std::size_t i = 0; i < kTables; ++i) {
      channels.push_back(AddChannel("/t" + std::to_string(i), "string text\n"));
    }
  }
  /// Writes this text to each topic.
  void WriteToAll(const std::string& text) {
    const auto length = static_cast<std::uint32_t>(text.size() + 1);
    std::string body(sizeof length, 0);
    std::memcpy(body.data(), &length, sizeof length);
    for (const mcap::ChannelId channel : channels) Write(channel, Encapsulated(body + text + '\0'));
  }
  Result<CsvReport> Export(const os::StopRequest& stop = {}) {
    EXPECT_TRUE(recording.writer->Close());
    reader = mcap::Open(recording.disk->bytes);
    return ExportCsv(*reader, {}, folder.path() / "csv", stop);
  }
  [[nodiscard]] bool Exists(const std::string& file) const {
    return std::filesystem::exists(folder.path() / "csv" / file);
  }

  std::vector<mcap::ChannelId> channels;
};

TEST_F(CsvExportOfManyTables, AreAllWrittenWithFewOpenFiles) {
  const std::string letters = "abc";
  for (const char letter : letters) WriteToAll(std::string(kLargeText, letter));
  const Limit limit(RLIMIT_NOFILE, OpenFiles(100));

  const auto report = Export();

  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->files.size(), kTables);
  EXPECT_EQ(report->others, letters.size() * kTables);
  EXPECT_EQ(report->incomplete, 0U);
  for (std::size_t i = 0; i < kTables; ++i) {
    std::string expected = "time_ns,source_time_ns,sequence,lost,value\n";
    for (std::size_t row = 0; row < letters.size(); ++row) {
      const std::string number = std::to_string(row * kTables + i + 1);
      expected += number + ',' + number + ',' + number + R"(,0,"{""text"":"")" +
                  std::string(kLargeText, letters[row]) + R"(""}")" + '\n';
    }
    EXPECT_TRUE(folder.Read("csv/t" + std::to_string(i) + ".csv") == expected) << i;
    EXPECT_FALSE(Exists("t" + std::to_string(i) + ".csv.part"));
  }
}

TEST_F(CsvExportOfManyTables, AFullDiskNamesTheFileAndLeavesNone) {
  for (const char letter : {'a', 'b', 'c'}) WriteToAll(std::string(kLargeText, letter));
  std::signal(SIGXFSZ, SIG_IGN);
  const Limit limit(RLIMIT_FSIZE, kLargeText + 1000);

  const auto report = Export();

  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().message, "cannot write " + (folder.path() / "csv/t0.csv").string() +
                                        ": File too large; no file was written");
  EXPECT_FALSE(Exists(""));
}

TEST_F(CsvExportOfManyTables, AFileThatAnotherProgramChangesMeanwhileIsNamed) {
  for (int i = 0; i < 20; ++i) WriteToAll("short");
  const auto change = [&] {
    if (Exists("t119.csv.part")) folder.Write("csv/t3.csv.part", "of somebody else");
    return false;
  };

  const auto report = Export(change);

  ASSERT_FALSE(report);
  EXPECT_THAT(report.error().message, HasSubstr("cannot write " + folder.path().string()));
  EXPECT_THAT(report.error().message,
              HasSubstr("t3.csv.part again: another program has changed it"));
  EXPECT_FALSE(Exists(""));
}

TEST_F(CsvExportOfManyTables, AnotherExportLeavesTheClosedFilesOfThisExport) {
  for (int i = 0; i < 20; ++i) WriteToAll("short");
  Result<CsvReport> other{CsvReport{}};
  const auto export_meanwhile = [&] {
    if (Exists("t119.csv.part")) {
      const auto same = mcap::Open(recording.disk->bytes);
      other = ExportCsv(*same, {.channels = {channels[0]}}, folder.path() / "csv");
    }
    return false;
  };

  const auto report = Export(export_meanwhile);

  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().code, ErrorCode::kExists);
  EXPECT_EQ(other.error().message, "another program is exporting into " +
                                       (folder.path() / "csv").string() +
                                       ": wait for its end, or choose another folder");
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->files.size(), kTables);
}

TEST_F(CsvExportOfOthers, AFailureWhenTheFilesGetTheirNamesLeavesNoneOfThem) {
  Write(AddChannel("/a", "uint8 x\n"), Encapsulated("1"));
  const auto last = AddChannel("/b", "uint8 x\n");
  for (int i = 0; i < 2000; ++i) Write(last, Encapsulated("1"));
  ASSERT_TRUE(recording.writer->Close());
  reader = mcap::Open(recording.disk->bytes);
  const auto make_the_last = [&] {  // another program, while the export looks at `stop`
    if (std::filesystem::exists(folder.path() / "csv" / "b.csv.part")) {
      folder.Write("csv/b.csv", "of somebody else");
    }
    return false;
  };

  const auto report = ExportCsv(*reader, {}, folder.path() / "csv", make_the_last);

  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, ErrorCode::kExists);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "csv" / "a.csv"));
  EXPECT_EQ(folder.Read("csv/b.csv"), "of somebody else");
}

TEST(CsvExportOfHostileFiles, AForeignFileIsRefusedAndNoNameLeavesTheFolder) {
  const test::Folder folder;
  const auto write = [&](const std::string& name, std::map<std::string, std::string> metadata) {
    auto writer = *mcap::Writer::Create(folder.path() / name);
    const auto channel = *writer->AddChannel(0, "../../etc/x", "cdr", std::move(metadata));
    EXPECT_TRUE(
        writer->Write(mcap::Message{channel, 0, 1, 1, mcap::BytesOf({"\0\1\0\0abcdefgh", 12})}));
    EXPECT_TRUE(writer->Close());
    return *mcap::Reader::Open(folder.path() / name);
  };
  const auto foreign = write("foreign.mcap", {});
  const auto refused = ExportCsv(*foreign, {}, folder.path() / "csv");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("has a description of its values"));

  const auto hostile = write("hostile.mcap", {{kSchemaKey, SchemaOf<double>().TextWithHelp()}});
  const auto report = ExportCsv(*hostile, {}, folder.path() / "csv");

  ASSERT_TRUE(report) << report.error().message;
  ASSERT_EQ(report->files.size(), 1U);
  EXPECT_EQ(report->files[0].parent_path(), folder.path() / "csv");
}

}  // namespace
}  // namespace tendon::recording
