#include <core/recording/recordings.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/folder.h>
#include <tendon/payload/codec.h>
#include <tendon/recording/hdf5/hdf5_module.h>
#include <tendon/recording/recording_format.h>
#include <tendon/recording/recording_writer.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tendon::recording {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The contents of the files are tested with h5py, by tests/python/hdf5_test.py.
class Hdf5Export : public testing::Test {
 protected:
  void SetUp() override {
    auto created = RecordingWriter::Create({.file = file}, {});
    ASSERT_TRUE(created) << created.error().message;
    files = *std::move(created);
  }
  void WriteTick(std::uint64_t tick, std::uint64_t epoch = 1) {
    auto source = std::make_shared<EntrySource>();
    source->name = {"robot", "counter", "state"};
    source->members = {{"Count", SchemaOf<std::uint64_t>()}};
    RowsEntry rows{.source = std::move(source), .epoch = epoch};
    rows.ticks = {tick};
    rows.times = {static_cast<std::int64_t>(1000 * tick)};
    Encode(tick, rows.cells);
    rows.cell_sizes = {8};
    ASSERT_TRUE(files->Write(rows));
  }
  Result<Hdf5Report> Export() {
    EXPECT_TRUE(files->Close({}));
    reader = *mcap::Reader::Open(file);
    return ExportHdf5(*reader, {}, output);
  }
  /// Returns true if Tendon was built without HDF5.
  static bool IsMissing(const Result<Hdf5Report>& report) {
    return !report && report.error().code == ErrorCode::kNotFound;
  }

  const test::Folder folder;
  const std::filesystem::path file = folder.path() / "run.mcap";
  const std::filesystem::path output = folder.path() / "run.h5";
  std::unique_ptr<RecordingWriter> files;
  std::unique_ptr<mcap::Reader> reader;
};

TEST_F(Hdf5Export, CountsRowsAndLostRowsButNotRestarts) {
  for (const std::uint64_t tick : {3, 4, 9}) WriteTick(tick);
  WriteTick(0, 2);

  const auto report = Export();

  if (IsMissing(report)) GTEST_SKIP() << report.error().message;
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_THAT(report->groups, ElementsAre("/robot/counter/state"));
  EXPECT_EQ(report->rows, 4U);
  EXPECT_EQ(report->lost, 4U);
  EXPECT_EQ(report->incomplete, 0U);
  EXPECT_TRUE(folder.Read("run.h5").starts_with("\x89HDF\r\n"));
  EXPECT_FALSE(std::filesystem::exists(output.string() + ".part"));
}

TEST_F(Hdf5Export, AnExportThatIsStoppedLeavesNoFile) {
  for (std::uint64_t tick = 0; tick < 2000; ++tick) WriteTick(tick);
  EXPECT_TRUE(files->Close({}));
  reader = *mcap::Reader::Open(file);

  const auto report = ExportHdf5(*reader, {}, output, [] { return true; });

  if (IsMissing(report)) GTEST_SKIP() << report.error().message;
  ASSERT_FALSE(report);
  EXPECT_THAT(report.error().message, HasSubstr("no file was written"));
  EXPECT_FALSE(std::filesystem::exists(output));
  EXPECT_FALSE(std::filesystem::exists(output.string() + ".part"));
}

TEST_F(Hdf5Export, ReplacesNoFile) {
  WriteTick(1);
  folder.Write("run.h5", "of somebody else");

  const auto report = Export();

  if (IsMissing(report)) GTEST_SKIP() << report.error().message;
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, ErrorCode::kExists);
  EXPECT_EQ(folder.Read("run.h5"), "of somebody else");
}

TEST_F(Hdf5Export, RefusesARecordingWithoutRows) {
  const auto report = Export();

  if (IsMissing(report)) GTEST_SKIP() << report.error().message;
  ASSERT_FALSE(report);
  EXPECT_THAT(report.error().message, HasSubstr("has a description of its values"));
  EXPECT_FALSE(std::filesystem::exists(output));
}

TEST_F(Hdf5Export, RefusesMoreDatasetsThanMemoryMayHold) {
  mcap::MemoryRecording recording;
  std::string text;
  for (int i = 0; i < 10'000; ++i) text += "uint8 f" + std::to_string(i) + "\n";
  const auto schema = *recording.writer->AddSchema("a/msg/B", kSchemaEncoding, text);
  for (int i = 0; i < 101; ++i) {  // columns of one table, which share a large type
    const auto channel =
        *recording.writer->AddChannel(schema, "robot/arm/state/C" + std::to_string(i), "cdr",
                                      {{kKindKey, kColumnKind}, {kEpochKey, "1"}});
    ASSERT_TRUE(recording.writer->Write(mcap::Message{channel, 0, 1, 1, {}}));
  }
  ASSERT_TRUE(recording.writer->Close());
  reader = mcap::Open(recording.disk->bytes);

  const auto report = ExportHdf5(*reader, {}, output);

  if (IsMissing(report)) GTEST_SKIP() << report.error().message;
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, ErrorCode::kInvalid);
  EXPECT_THAT(report.error().message, HasSubstr("more than 1000000 columns"));
  EXPECT_FALSE(std::filesystem::exists(output));
}

TEST_F(Hdf5Export, SaysWhyAFolderCannotBeWritten) {
  WriteTick(1);
  EXPECT_TRUE(files->Close({}));
  reader = *mcap::Reader::Open(file);

  const auto report = ExportHdf5(*reader, {}, folder.path() / "none" / "run.h5");

  if (IsMissing(report)) GTEST_SKIP() << report.error().message;
  ASSERT_FALSE(report);
  EXPECT_THAT(report.error().message, HasSubstr("No such file or directory"));
}

TEST(Hdf5Module, AModuleOfAnotherBuildIsRefused) {
  const auto module = LoadHdf5Module(TENDON_OTHER_HDF5_MODULE);

  ASSERT_FALSE(module);
  EXPECT_EQ(module.error().code, ErrorCode::kInvalid);
  EXPECT_THAT(module.error().message, HasSubstr("belongs to another build of Tendon (expected " +
                                                Hdf5Build() + "; found module 0)"));
}

TEST(Hdf5Module, AMissingFileIsNamedWithTheNextStep) {
  const auto module = LoadHdf5Module("/none/tendon_hdf5.so");

  ASSERT_FALSE(module);
  EXPECT_EQ(module.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(module.error().message, HasSubstr("install libhdf5-dev"));
}

}  // namespace
}  // namespace tendon::recording
