#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>
#include <tendon/gcm/text.h>
#include <tendon/payload/codec.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/mcap/verify.h>
#include <tendon/recording/recording_format.h>
#include <tendon/recording/recording_writer.h>

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "gcm_console/system_fixture.h"

namespace {

namespace mcap = tendon::mcap;
namespace recording = tendon::recording;
using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::StartsWith;

/// A message, without its encapsulation.
struct ReadMessage {
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0;
  std::vector<std::byte> body;

  template <typename T>
  [[nodiscard]] T As() const {
    T value{};
    EXPECT_TRUE(tendon::Decode(body, value));
    return value;
  }
};

/// Runs `gcm record` and the verbs for recordings with a real GCM and LCM. `robot/odometer` counts
/// at 100 Hz.
class RecordTest : public SystemFixture {
 protected:
  void SetUp() override {
    StartGcm();
    robot = StartRobot();
  }
  [[nodiscard]] std::unique_ptr<Program> StartRobot() const {
    auto program = StartOne("robot", "odometer", "Odometer", "odometer");
    EXPECT_TRUE(EventuallySays({"ls", "robot"}, "odometer\tactive")) << program->err();
    return program;
  }

  [[nodiscard]] std::string Path(const std::string& name) const {
    return (home.path() / name).string();
  }
  [[nodiscard]] std::unique_ptr<Program> Record(Program::Words words) const {
    words.insert(words.begin(), {Binary("gcm"), "--gcm", address, "--timeout", kTestTimeout,
                                 "--jsonl", "record", "-o", file});
    return std::make_unique<Program>(words);
  }
  /// Returns the last line that the program has printed; null if there is none yet.
  static json LastLine(const Program& record) {
    json last;
    std::istringstream lines(record.out());
    for (std::string line; std::getline(lines, line);) {
      auto value = json::parse(line, nullptr, false);
      if (!value.is_discarded()) last = std::move(value);
    }
    return last;
  }
  static bool EventuallyRows(const Program& record, std::uint64_t rows) {
    return EventuallyTrue([&] {
      const json last = LastLine(record);
      return last.is_object() && last.value("rows", std::uint64_t{0}) >= rows;
    });
  }
  static std::optional<int> Interrupt(Program& record) {
    record.Signal(SIGINT);
    return record.Wait();
  }
  /// Makes a recording of about a second.
  void RecordSome(const Program::Words& words = {"**"}) const {
    const auto record = Record(words);
    ASSERT_TRUE(EventuallyRows(*record, 60)) << record->err();
    ASSERT_EQ(Interrupt(*record), program::kInterrupted) << record->err();
  }

  static std::map<std::string, std::vector<ReadMessage>> Read(const std::string& name) {
    std::map<std::string, std::vector<ReadMessage>> all;
    const auto reader = mcap::Reader::Open(std::filesystem::path(name));
    EXPECT_TRUE(reader) << reader.error().message;
    if (!reader) return all;
    auto messages = (*reader)->Messages({.order = mcap::Query::Order::kFile});
    while (const auto message = messages.Next()) {
      const auto body = message->data.subspan(recording::kEncapsulationSize);
      all[(*reader)->FindChannel(message->channel_id)->topic].push_back(
          {message->sequence, message->log_time, {body.begin(), body.end()}});
    }
    EXPECT_EQ((*reader)->problems().count(), 0U);
    return all;
  }
  /// Returns the time at which a file begins, in ns.
  static std::int64_t BeginOf(const std::string& name) {
    const auto reader = mcap::Reader::Open(std::filesystem::path(name));
    EXPECT_TRUE(reader) << reader.error().message;
    if (!reader) return 0;
    const auto about = (*reader)->ReadMetadata((*reader)->metadata().at(0));
    return about ? std::stoll(about->metadata.at("begin_ns")) : 0;
  }
  static std::string TextOf(const std::filesystem::path& path) {
    std::stringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
  }

  const std::string file = Path("run.mcap");
  std::unique_ptr<Program> robot;
};

TEST_F(RecordTest, HoldsEachRowOnceWithConsecutiveTicks) {
  const auto record = Record({"robot/odometer"});
  ASSERT_TRUE(EventuallyRows(*record, 150)) << record->err();
  ASSERT_EQ(Interrupt(*record), program::kInterrupted) << record->err();

  const json end = LastLine(*record);
  EXPECT_EQ(end["end"], true);
  EXPECT_EQ(end["lost_table"].get<int>() + end["lost_network"].get<int>() +
                end["lost_recorder"].get<int>(),
            0);
  EXPECT_THAT(record->err(), HasSubstr("gcm: recording 1 table"));
  auto topics = Read(file);
  const auto& counts = topics["robot/odometer/state/Count"];
  const auto& stamps = topics["robot/odometer/state/Stamp"];
  EXPECT_EQ(counts.size(), end["rows"].get<std::size_t>());
  ASSERT_EQ(stamps.size(), counts.size());
  for (std::size_t i = 1; i < counts.size(); ++i) {
    ASSERT_EQ(counts[i].sequence, counts[i - 1].sequence + 1);
    ASSERT_EQ(counts[i].As<std::uint64_t>(), counts[i - 1].As<std::uint64_t>() + 1);
    ASSERT_GT(counts[i].log_time, counts[i - 1].log_time);
    ASSERT_EQ(stamps[i].sequence, counts[i].sequence);
    ASSERT_EQ(stamps[i].As<std::int64_t>() - stamps[i - 1].As<std::int64_t>(), 10'000'000);
  }
}

TEST_F(RecordTest, ASecondRecorderOfAFileIsRefusedAndTheFirstGoesOn) {
  const auto record = Record({"robot/odometer"});
  ASSERT_TRUE(EventuallyRows(*record, 1)) << record->err();

  const Outcome second = Gcm({"record", "**", "-o", file, "--for", "1s"});
  const Outcome saved = Gcm({"save-last", "1s", "robot", "-o", file});

  EXPECT_EQ(second.exit_code, program::kRefused);
  EXPECT_THAT(second.err, HasSubstr(file + " is being recorded: choose another "
                                           "name, or stop that recording first"));
  EXPECT_EQ(saved.exit_code, program::kRefused);
  EXPECT_THAT(saved.err, HasSubstr("is being recorded"));
  const auto before = LastLine(*record)["rows"].get<std::uint64_t>();
  EXPECT_TRUE(EventuallyRows(*record, before + 30)) << record->err();
  EXPECT_EQ(Interrupt(*record), program::kInterrupted) << record->err();
  EXPECT_GT(Read(file)["robot/odometer/state/Count"].size(), 30U);
}

TEST_F(RecordTest, EndsByItselfAfterItsTime) {
  const Outcome recorded = Gcm({"record", "robot/**", "-o", file, "--for", "1500ms", "--json"});

  EXPECT_EQ(recorded.exit_code, program::kOk) << recorded.err;
  EXPECT_THAT(recorded.err, HasSubstr(" rows lost, 0 events and commands lost\n"));
  EXPECT_GT(Read(file)["robot/odometer/state/Count"].size(), 10U);
}

TEST_F(RecordTest, BeginsAfterItsDelay) {
  const std::int64_t before = tendon::WallTime();

  const Outcome recorded = Gcm({"record", "robot", "-o", file, "--delay", "1500ms", "--for", "3s"});

  ASSERT_EQ(recorded.exit_code, program::kOk) << recorded.err;
  const auto rows = Read(file)["robot/odometer/state/Count"];
  ASSERT_FALSE(rows.empty());
  EXPECT_GE(rows.front().log_time, static_cast<std::uint64_t>(before) + 1'500'000'000);
}

TEST_F(RecordTest, BeginsAnotherFileAfterTheTimeOfASplit) {
  const auto record = Record({"robot", "--split-time", "500ms"});
  const auto part = [&](int number) { return Path("run-" + std::to_string(number) + ".mcap"); };
  ASSERT_TRUE(EventuallyTrue([&] { return std::filesystem::exists(part(4)); })) << record->err();
  ASSERT_EQ(Interrupt(*record), program::kInterrupted) << record->err();

  EXPECT_FALSE(std::filesystem::exists(file));
  std::vector<ReadMessage> rows;
  std::int64_t begin = 0;
  for (int number = 1; number <= 4; ++number) {
    SCOPED_TRACE(part(number));
    auto topics = Read(part(number));
    EXPECT_FALSE(topics[recording::kCatalogueTopic].empty()) << "it can be read alone";
    const auto& more = topics["robot/odometer/state/Count"];
    rows.insert(rows.end(), more.begin(), more.end());
    const std::int64_t last = std::exchange(begin, BeginOf(part(number)));
    if (number > 1) EXPECT_GE(begin - last, 500'000'000);
  }
  ASSERT_GT(rows.size(), 100U);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].sequence, rows[i - 1].sequence + 1) << "no row is between two files";
  }
}

TEST_F(RecordTest, RecordsWhatComesLaterAndSaysThatItIsNotThereYet) {
  const auto record = Record({"hall"});
  ASSERT_TRUE(EventuallyTrue([&] {
    return record->err().find("no table, event or command matches 'hall' now") != std::string::npos;
  })) << record->err();

  const auto hall = StartOne("hall", "odometer", "Odometer", "odometer");
  ASSERT_TRUE(EventuallyRows(*record, 30)) << record->err();
  ASSERT_EQ(Interrupt(*record), program::kInterrupted) << record->err();

  auto topics = Read(file);
  EXPECT_GE(topics["hall/odometer/state/Count"].size(), 30U);
  EXPECT_FALSE(topics.contains("robot/odometer/state/Count"));
}

TEST_F(RecordTest, ContinuesWithARestartedProcessAndWithoutAGcm) {
  const auto record = Record({"**"});
  ASSERT_TRUE(EventuallyRows(*record, 30)) << record->err();

  robot->Signal(SIGKILL);
  ASSERT_TRUE(robot->Wait());
  robot = StartRobot();
  const auto before = LastLine(*record)["rows"].get<std::uint64_t>();
  ASSERT_TRUE(EventuallyRows(*record, before + 100)) << record->err();
  gcm->Signal(SIGKILL);
  ASSERT_TRUE(gcm->Wait());
  ASSERT_TRUE(EventuallyTrue([&] { return record->err().find(address) != std::string::npos; }));
  const auto later = LastLine(*record)["rows"].get<std::uint64_t>();
  ASSERT_TRUE(EventuallyRows(*record, later + 100)) << record->err();
  ASSERT_EQ(Interrupt(*record), program::kInterrupted) << record->err();

  const auto reader = mcap::Reader::Open(std::filesystem::path(file));
  ASSERT_TRUE(reader);
  EXPECT_EQ(tendon::mcap::Verify(**reader).problems.count(), 0U);
  std::size_t channels = 0;
  for (const auto& [id, channel] : (*reader)->channels()) {
    channels += channel.topic == "robot/odometer/state/Count" ? 1 : 0;
  }
  EXPECT_EQ(channels, 2U) << "one for each run of the process";
}

TEST_F(RecordTest, AKilledRecorderLeavesAFileThatCanBeRecovered) {
  const auto record = Record({"**"});
  ASSERT_TRUE(EventuallyRows(*record, 200)) << record->err();
  record->Signal(SIGKILL);
  ASSERT_TRUE(record->Wait());

  const Outcome info = Gcm({"info", file});
  const Outcome recovered = Gcm({"recover", file, "--json"});

  EXPECT_EQ(info.exit_code, program::kPartial);
  EXPECT_THAT(info.out, HasSubstr("robot/odometer/state/Count"));
  EXPECT_THAT(info.err, HasSubstr("the end of the file is missing"));
  EXPECT_THAT(info.err, HasSubstr("run.mcap is damaged; to copy everything that can be read into a "
                                  "new file: gcm recover " +
                                  file));
  ASSERT_EQ(recovered.exit_code, program::kOk) << recovered.err;
  const std::string mended = json::parse(recovered.out)["file"];
  EXPECT_EQ(mended, Path("run-recovered.mcap"));
  const auto counts = Read(mended)["robot/odometer/state/Count"];
  EXPECT_GT(counts.size(), 50U);
  for (std::size_t i = 1; i < counts.size(); ++i) {
    ASSERT_EQ(counts[i].sequence, counts[i - 1].sequence + 1);
  }
  EXPECT_EQ(Gcm({"info", mended, "--check"}).exit_code, program::kOk);
  EXPECT_EQ(Gcm({"recover", file}).exit_code, program::kRefused) << "the new file is there already";
}

TEST_F(RecordTest, AFullDiskEndsTheRecordingWithWhatIsSafe) {
  // Beyond this size, writing fails with "File too large".
  Program record({"/bin/sh", "-c",
                  "trap '' XFSZ; ulimit -f 512; exec " + Binary("gcm") + " --gcm " + address +
                      " --timeout " + kTestTimeout + " record '**' --compression none -o " + file});

  ASSERT_EQ(record.Wait(), program::kRefused) << record.err();

  EXPECT_THAT(record.err(), HasSubstr("File too large"));
  EXPECT_THAT(record.err(), HasSubstr(" are in the file"));
  const Outcome info = Gcm({"info", file, "--json"});
  const json document = json::parse(info.out);
  EXPECT_THAT(info.out, HasSubstr("robot/odometer/state/Count")) << info.err;
  EXPECT_GT(document["seconds"].get<double>(), 0.5);
  EXPECT_THAT(Gcm({"ls", "robot"}).out, HasSubstr("active"));
}

TEST_F(RecordTest, BeginsAndEndsWithConditions) {
  const auto set_count = [&](const std::string& count) {
    const Outcome set = Gcm({"call", "robot/odometer/Control.SetCount", count});
    EXPECT_EQ(set.exit_code, program::kOk) << set.err;
  };
  const auto record =
      Record({"robot/odometer", "--start-when", "robot/odometer/state.Count >= 1000000000000000000",
              "--before", "10min", "--stop-when", "robot/odometer/state.Count < 1000", "--after",
              "100ms"});
  ASSERT_TRUE(EventuallyTrue([&] {
    const json last = LastLine(*record);
    // More than only the catalogue.
    return last.is_object() && last.value("before_bytes", 0) > 60'000;
  })) << record->err();
  EXPECT_THAT(record->err(), HasSubstr("gcm: waiting for robot/odometer/state.Count >= "));

  set_count("1000000000000000000");
  ASSERT_TRUE(EventuallyRows(*record, 1)) << record->err();
  set_count("5");

  ASSERT_EQ(record->Wait(), program::kOk) << record->err();
  EXPECT_THAT(record->err(), HasSubstr("gcm: the condition is true: recording into "));
  const auto rows = Read(file)["robot/odometer/state/Count"];
  ASSERT_FALSE(rows.empty());
  constexpr std::uint64_t kStart = 1'000'000'000'000'000'000;
  EXPECT_LT(rows.front().As<std::uint64_t>(), kStart) << "what came before";
  EXPECT_GT(rows.front().As<std::uint64_t>(), 1000U);
  EXPECT_THAT(rows, Contains(testing::Truly(
                        [](const ReadMessage& row) { return row.As<std::uint64_t>() >= kStart; })));
  EXPECT_LT(rows.back().As<std::uint64_t>(), 1000U);
}

TEST_F(RecordTest, AConditionThatIsWrongIsRefused) {
  const auto refused = [&](const std::string& condition) {
    return Gcm({"record", "**", "-o", file, "--start-when", condition});
  };

  const Outcome mistake = refused("robot/odometer/state.Count = 3");
  EXPECT_EQ(mistake.exit_code, program::kUsage);
  EXPECT_THAT(mistake.err, HasSubstr("column 28: expected one of <"));
  const Outcome missing = refused("robot/odometer/state.Counted > 3");
  EXPECT_EQ(missing.exit_code, program::kNotFound);
  EXPECT_THAT(missing.err, HasSubstr("did you mean 'Count'?"));
  const Outcome before = Gcm({"record", "**", "-o", file, "--before", "2s"});
  EXPECT_EQ(before.exit_code, program::kUsage);
  EXPECT_THAT(before.err, HasSubstr("--before needs --start-when"));
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(RecordTest, SaveLastWritesWhatTheProcessesHaveKeptAndSaysHowFarItReaches) {
  ASSERT_EQ(Gcm({"call", "robot/odometer/Control.SetCount", "0"}).exit_code, program::kOk);
  ASSERT_TRUE(EventuallyTrue([&] {
    const auto count = std::stoull(Gcm({"get", "robot/odometer/state.Count"}).out);
    return count > 100 && count < 1'000'000;
  }));

  const Outcome saved = Gcm({"save-last", "30min", "robot/odometer", "-o", file, "--json"});

  ASSERT_EQ(saved.exit_code, program::kOk) << saved.err;
  const json report = json::parse(saved.out);
  EXPECT_EQ(report["tables"][0]["path"], "robot/odometer/state");
  EXPECT_GT(report["tables"][0]["seconds"].get<double>(), 0.5);
  EXPECT_EQ(report["losses"], json::array());
  const auto rows = Read(file)["robot/odometer/state/Count"];
  EXPECT_EQ(rows.size(), report["tables"][0]["rows"].get<std::size_t>());
  EXPECT_GE(rows.size(), 100U);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].sequence, rows[i - 1].sequence + 1);
  }
  EXPECT_EQ(Gcm({"save-last", "1s", "desk", "-o", Path("none.mcap")}).exit_code,
            program::kNotFound);
}

TEST_F(RecordTest, SaveLastSaysWhyAProcessReachesBackLess) {
  ASSERT_TRUE(EventuallyTrue([&] {
    return std::stoull(Gcm({"get", "robot/odometer/state.Count"}).out) > 20;
  }));

  const Outcome young = Gcm({"save-last", "60min", "robot", "-o", file});

  ASSERT_EQ(young.exit_code, program::kOk) << young.err;
  EXPECT_THAT(young.err, HasSubstr("gcm: robot reached back "));
  EXPECT_THAT(young.err, HasSubstr("it has not been running longer"));
  EXPECT_THAT(Gcm({"show", "robot"}).out, HasSubstr(" of 32.0 MiB"));
  const json shown = json::parse(Gcm({"show", "robot", "--json"}).out);
  EXPECT_EQ(shown["process"]["history"]["limit_bytes"], 32 << 20);
}

TEST_F(RecordTest, SaveLastOfAKilledProcessSaysSo) {
  robot->Signal(SIGKILL);
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\tlost"));

  const Outcome saved = Gcm({"save-last", "30s", "robot", "-o", file});

  EXPECT_EQ(saved.exit_code, program::kPartial) << saved.err;
  EXPECT_THAT(saved.out, HasSubstr("robot/odometer/state: nothing: "));
}

TEST_F(RecordTest, RefusalsNameTheCause) {
  home.Write("run.mcap", "");
  const Outcome exists = Gcm({"record", "**", "-o", file, "--for", "1s"});
  EXPECT_EQ(exists.exit_code, program::kRefused);
  EXPECT_THAT(exists.err, HasSubstr(" already exists, and a recording never replaces a file"));

  const Outcome nowhere = Gcm({"record", "**", "-o", Path("none/run.mcap"), "--for", "1s"});
  EXPECT_EQ(nowhere.exit_code, program::kRefused);
  EXPECT_THAT(nowhere.err, HasSubstr("No such file or directory"));

  const Outcome keep = Gcm({"record", "**", "-o", Path("new.mcap"), "--keep", "2"});
  EXPECT_EQ(keep.exit_code, program::kUsage);
  EXPECT_THAT(keep.err, HasSubstr("--keep needs --split-size or --split-time"));
}

TEST_F(RecordTest, InfoShowsTopicsAndWhatIsNoRecordingIsNamed) {
  RecordSome();

  const Outcome info = Gcm({"info", file, "--check", "--json"});
  ASSERT_EQ(info.exit_code, program::kOk) << info.err;
  const json document = json::parse(info.out);
  EXPECT_EQ(document["profile"], "ros2");
  std::map<std::string, json> topics;
  for (const auto& topic : document["topics"]) topics[topic["topic"]] = topic;
  ASSERT_TRUE(topics.contains("robot/odometer/state/Edges")) << info.out;
  EXPECT_EQ(topics["robot/odometer/state/Edges"]["type"], "odometer/msg/Edges");
  EXPECT_GE(topics["robot/odometer/state/Edges"]["messages"], 60);
  EXPECT_NEAR(topics["robot/odometer/state/Edges"]["rate_hz"].get<double>(), 100.0, 60.0);
  EXPECT_EQ(document["attachments"][0]["name"], "system.json");

  home.Write("some.zip", "PK\3\4 and more than eight bytes");
  const Outcome zip = Gcm({"info", Path("some.zip")});
  EXPECT_EQ(zip.exit_code, program::kUsage);
  EXPECT_THAT(zip.err, HasSubstr("PK"));
  EXPECT_EQ(Gcm({"info", Path("none.mcap")}).exit_code, program::kNotFound);
}

TEST_F(RecordTest, InfoShowsTheRowsThatARecordingHasLost) {
  const auto source = std::make_shared<recording::EntrySource>();
  source->name = {"robot", "arm", "state"};
  source->members = {{"Count", tendon::SchemaOf<std::uint64_t>()}};
  recording::RowsEntry rows{.source = source, .ticks = {9}, .times = {1}, .cell_sizes = {8}};
  rows.lost_before = {.table = 1, .network = 2, .viewer = 4};
  rows.cells.resize(8);
  auto writer = recording::RecordingWriter::Create({.file = file}, {});
  ASSERT_TRUE(writer) << writer.error().message;
  ASSERT_TRUE((*writer)->Write(rows));
  ASSERT_TRUE((*writer)->WriteLoss("robot/arm/state", {.table = 0, .network = 0, .viewer = 8}));
  ASSERT_TRUE((*writer)->Close({}));

  const Outcome info = Gcm({"info", file});
  const Outcome as_json = Gcm({"info", file, "--json"});

  EXPECT_EQ(info.exit_code, program::kOk) << info.err;
  EXPECT_THAT(info.out, testing::ContainsRegex("robot/arm/state/Count\t[^\n]*\t15\n"));
  for (const auto& topic : json::parse(as_json.out)["topics"]) {
    EXPECT_EQ(topic["lost"], topic["topic"] == "robot/arm/state/Count" ? 15 : 0) << topic;
  }
}

TEST_F(RecordTest, CutCopiesTheChosenTimeAndPaths) {
  RecordSome();
  const std::string part = Path("part.mcap");

  const Outcome cut = Gcm({"cut", file, "-o", part, "--paths", "robot/odometer/state.Count",
                           "--from", "200ms", "--to", "400ms", "--json"});

  ASSERT_EQ(cut.exit_code, program::kOk) << cut.err;
  auto all = Read(file);
  auto some = Read(part);
  std::uint64_t begin = ~std::uint64_t{0};
  for (const auto& [topic, messages] : all) {
    for (const auto& message : messages) begin = std::min(begin, message.log_time);
  }
  std::vector<std::uint32_t> expected;
  for (const auto& message : all["robot/odometer/state/Count"]) {
    const std::uint64_t after = message.log_time - begin;
    if (after >= 200'000'000 && after < 400'000'000) expected.push_back(message.sequence);
  }
  ASSERT_FALSE(expected.empty());
  std::vector<std::uint32_t> found;
  for (const auto& message : some["robot/odometer/state/Count"]) found.push_back(message.sequence);
  EXPECT_EQ(found, expected);
  EXPECT_FALSE(some.contains("robot/odometer/state/Stamp"));
  EXPECT_EQ(json::parse(cut.out)["messages"], expected.size());
  EXPECT_EQ(Gcm({"cut", file, "-o", Path("x.mcap"), "--paths", "desk"}).exit_code,
            program::kNotFound);
}

TEST_F(RecordTest, ExportWritesEachTableAsCsvWithAllDigits) {
  RecordSome();
  const std::string folder = Path("csv");

  const Outcome exported = Gcm({"export", file, "--csv", folder, "--paths",
                                "robot/odometer/state.Count", "robot/odometer/state.Edges"});

  ASSERT_EQ(exported.exit_code, program::kOk) << exported.err;
  EXPECT_EQ(exported.out, folder + "/robot.odometer.state.csv\n");
  std::istringstream lines(TextOf(std::filesystem::path(folder) / "robot.odometer.state.csv"));
  std::string titles;
  std::getline(lines, titles);
  EXPECT_THAT(titles, StartsWith("time_ns,source_time_ns,sequence,lost,Count,Edges.zero,"));
  const auto counts = Read(file)["robot/odometer/state/Count"];
  std::size_t row = 0;
  for (std::string line; std::getline(lines, line); ++row) {
    ASSERT_LT(row, counts.size());
    unsigned long long time = 0;
    unsigned long long count = 0;
    unsigned long tick = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%llu,%*d,%lu,0,%llu,", &time, &tick, &count), 3) << line;
    EXPECT_EQ(time, counts[row].log_time);
    EXPECT_EQ(tick, counts[row].sequence);
    EXPECT_EQ(count, counts[row].As<std::uint64_t>()) << "beyond what a double holds";
    EXPECT_THAT(line, HasSubstr(",nan,-inf,"));
  }
  EXPECT_EQ(row, counts.size());
  EXPECT_EQ(Gcm({"export", file, "--csv", folder}).exit_code, program::kRefused)
      << "no file is replaced";
}

}  // namespace
