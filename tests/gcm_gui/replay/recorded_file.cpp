#include "replay/recorded_file.h"

#include <gtest/gtest.h>
#include <tendon/payload/codec.h>
#include <tendon/payload/payload.h>
#include <tendon/recording/mcap/writer.h>
#include <tendon/recording/recording_format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "support/sample_system.h"

namespace tendon::gui {

struct RecordedJoints {
  std::array<double, 2> position{};
};
/// What a later program calls the same column.
struct RecordedJointsLater {
  double temperature = 0;
  std::array<double, 2> position{};
};

}  // namespace tendon::gui

template <>
inline constexpr auto tendon::kPayload<tendon::gui::RecordedJoints> = tendon::Describe(
    "arm.JointState", tendon::Field{"position", &tendon::gui::RecordedJoints::position, "rad"});
template <>
inline constexpr auto tendon::kPayload<tendon::gui::RecordedJointsLater> = tendon::Describe(
    "arm.JointState",
    tendon::Field{"temperature", &tendon::gui::RecordedJointsLater::temperature, "degC"},
    tendon::Field{"position", &tendon::gui::RecordedJointsLater::position, "rad"});

namespace tendon::gui {
namespace {

constexpr std::int64_t kStep = kSecond / 100;
constexpr int kRows = 2000;

class Pen {
 public:
  explicit Pen(const std::string& file) {
    auto writer = mcap::Writer::Create(file, {.profile = recording::kProfile});
    EXPECT_TRUE(writer) << (writer ? "" : writer.error().message);
    writer_ = *std::move(writer);
  }
  ~Pen() { EXPECT_TRUE(writer_->Close()); }
  Pen(const Pen&) = delete;
  Pen& operator=(const Pen&) = delete;

  template <typename T>
  mcap::ChannelId channel(const std::string& topic, const char* kind, const char* epoch = "1") {
    const auto schema =
        writer_->AddSchema(topic, recording::kSchemaEncoding, SchemaOf<T>().TextWithHelp());
    return *writer_->AddChannel(*schema, topic, recording::kMessageEncoding,
                                {{recording::kKindKey, kind},
                                 {recording::kPathKey, topic},
                                 {recording::kSchemaKey, SchemaOf<T>().TextWithHelp()},
                                 {recording::kEpochKey, epoch}});
  }
  template <typename T>
  void write(mcap::ChannelId channel, std::int64_t since_begin, const T& value) {
    std::vector<std::byte> encoded;
    Encode(value, encoded);
    std::vector<std::byte> data(recording::kEncapsulationSize);
    data[1] = std::byte{1};
    data.insert(data.end(), encoded.begin(), encoded.end());
    const auto time = static_cast<mcap::Timestamp>(kRunBegin + since_begin);
    EXPECT_TRUE(writer_->Write(mcap::Message{channel, sequences_[channel]++, time, time, data}));
  }
  void skip(mcap::ChannelId channel, std::uint32_t rows) { sequences_[channel] += rows; }
  void sync() const { EXPECT_TRUE(writer_->Sync()); }

 private:
  std::unique_ptr<mcap::Writer> writer_;
  std::map<mcap::ChannelId, std::uint32_t> sequences_;
};

void WriteAll(Pen& pen) {
  const auto catalogue =
      pen.channel<CatalogueChange>(recording::kCatalogueTopic, recording::kOtherKind);
  const auto log = pen.channel<recording::RosLog>(recording::kLogTopic, recording::kOtherKind);
  const auto lost = pen.channel<recording::Loss>(recording::kLossTopic, recording::kOtherKind);
  const auto joints = pen.channel<RecordedJoints>("robot/arm/state.Joints", recording::kColumnKind);
  const auto heat = pen.channel<double>("robot/arm/state.Temperature", recording::kColumnKind);
  const auto limit = pen.channel<double>("robot/arm/Drives.LimitExceeded", recording::kEventKind);
  SystemBuilder system = LookSystem(kRunBegin);
  const auto write_changes = [&](std::int64_t time) {
    for (const CatalogueChange& change : system.TakeChanges()) pen.write(catalogue, time, change);
  };
  const auto set_arm = [&](ComponentState state) {
    ComponentDescription arm = *system.catalogue().FindComponent("robot", "arm");
    arm.state = state;
    system.Component("robot", arm);
  };
  write_changes(0);
  pen.write(heat, 0, 20.0);
  for (int row = 0; row < kRows; ++row) {
    const std::int64_t time = row * kStep;
    const double seconds = static_cast<double>(row) / 100;
    if (row % 100 == 0) pen.sync();
    if (row == 100) {
      pen.write(log, time,
                recording::RosLog{.stamp = std::chrono::nanoseconds(kRunBegin + time),
                                  .level = 20,
                                  .name = "robot/arm",
                                  .msg = "homed"});
    }
    if (row == 300) {
      pen.write(log, time,
                recording::RosLog{.stamp = std::chrono::nanoseconds(kRunBegin + time),
                                  .level = 20,
                                  .name = "robot/audit",
                                  .msg = "desk (operator, local): call a command "
                                         "arm/Control.MoveTo: allowed"});
    }
    if (row == 800) {
      system.Connect({"desk", "teleoperation", "Robot"}, {"robot", "controller", "Control"});
    }
    if (row == 1200) {
      set_arm(ComponentState::kSuspended);
      pen.write(log, time,
                recording::RosLog{.stamp = std::chrono::nanoseconds(kRunBegin + time),
                                  .level = 30,
                                  .name = "robot/arm",
                                  .msg = "suspended by hand"});
    }
    if (row == 1600) set_arm(ComponentState::kActive);
    write_changes(time);
    if (row == 500 || row == 900 || row == 1500) pen.write(limit, time, seconds);
    if (row >= 1000 && row < 1050) {
      pen.skip(joints, 1);
      continue;
    }
    if (row == 1050) pen.write(lost, time, recording::Loss{"robot/arm/state", 50, 0, 0});
    pen.write(joints, time, RecordedJoints{{seconds, std::sin(seconds)}});
  }
}

}  // namespace

void WriteRun(const QString& file, FileEnd end) {
  {
    Pen pen(file.toStdString());
    WriteAll(pen);
  }
  if (end == FileEnd::kComplete) return;
  const std::filesystem::path path = file.toStdString();
  std::filesystem::resize_file(path, std::filesystem::file_size(path) * 9 / 10);
}

std::shared_ptr<void> BeginRun(const QString& file) {
  const auto pen = std::make_shared<Pen>(file.toStdString());
  WriteAll(*pen);
  pen->sync();
  return pen;
}

void WriteTwoTypes(const QString& file) {
  Pen pen(file.toStdString());
  const auto first = pen.channel<RecordedJoints>("robot/arm/state.Joints", recording::kColumnKind);
  const auto second =
      pen.channel<RecordedJointsLater>("robot/arm/state.Joints", recording::kColumnKind, "2");
  for (int row = 0; row < 5; ++row) pen.write(first, row * kStep, RecordedJoints{{1.0, 2.0}});
  for (int row = 5; row < 10; ++row) {
    pen.write(second, row * kStep, RecordedJointsLater{40.0, {3.0, 4.0}});
  }
}

}  // namespace tendon::gui
