#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/folder.h>
#include <tendon/gcm/text.h>
#include <tendon/payload/codec.h>
#include <tendon/recording/csv_export.h>
#include <tendon/recording/recording_files.h>

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

std::shared_ptr<const Source> CartTable() {
  auto source = std::make_shared<Source>();
  source->name = {"robot", "cart", "state"};
  source->members = {{"Wheel", SchemaOf<Wheel>()}, {"Count", SchemaOf<std::uint64_t>()}};
  return source;
}

/// Returns a batch of one row.
Rows RowOf(std::uint64_t tick, const Wheel& wheel, std::uint64_t epoch = 1) {
  Rows rows{.source = CartTable(), .epoch = epoch};
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
    auto created = Files::Create({.file = file}, {});
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
  std::unique_ptr<Files> files;
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
  auto source = std::make_shared<Source>();
  source->name = {"robot", "cart", "Control"};
  source->members = {{"Stopped", Schema()}, {"Passed", SchemaOf<double>()}};
  std::vector<std::byte> value;
  Encode(1.5, value);
  ASSERT_TRUE(files->Write(Event{source, 0, SteadyClock().Now(), {}}));
  ASSERT_TRUE(files->Write(Event{source, 1, SteadyClock().Now(), value}));

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
  EXPECT_EQ(report->rows, 3U);
  EXPECT_EQ(report->lost, 0U);
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

TEST(CsvExportOfOthers, AForeignFileIsRefusedAndNoNameLeavesTheFolder) {
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
