#pragma once

#include <gtest/gtest.h>
#include <support/folder.h>
#include <support/memory_file.h>
#include <support/wait.h>
#include <tendon/gcm/global_manager.h>
#include <tendon/middleware/loopback.h>
#include <tendon/process/process.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/recorder.h>
#include <tendon/recording/recording_format.h>
#include <tendon/task/periodic_task.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "recordings.h"

/// A running system that is recorded: for the tests of the recorder, its triggers and save-last.

namespace tendon::recording {

/// Writes the number of its cycle into two columns, and raises it as an event.
class Odometer final : public PeriodicTask {
 public:
  explicit Odometer(std::string name)
      : PeriodicTask(std::move(name), std::chrono::milliseconds(1)) {
    state_table().Add(number_, "Number");
    state_table().Add(half_, "Half");
    state_table().SetLength(kRows);
    auto& control = AddProvidedInterface("Control");
    control.AddEvent(passed_, "Passed");
    control.AddCommandVoid(&Odometer::Reverse, this, "Reverse");
  }
  ~Odometer() override { Join(); }

  static constexpr std::size_t kRows = 8192;  // no loss on a busy machine

  void Run() override {
    ProcessQueuedCommands();
    ++number_;
    half_ = direction_ * 0.5 * static_cast<double>(number_);
    passed_(number_);
  }

 private:
  void Reverse() { direction_ = -1.0; }

  double direction_ = 1.0;
  std::uint64_t number_ = 0;
  double half_ = 0.0;
  WriteEvent<std::uint64_t> passed_;
};

inline constexpr const char* kDiskFull = "No space left on device (0 B free)";

/// A disk that waits while `gate` is locked, and that can fail. Lock `gate` to change it.
struct FaultyDisk {
  std::mutex gate;
  std::string failure;         ///< the reason why nothing can be written; empty: all is well
  bool leaves_halves = false;  ///< half of a chunk that cannot be written is in the file
  bool can_sync = true;
};

class FileOnFaultyDisk final : public os::WritableFile {
 public:
  FileOnFaultyDisk(std::unique_ptr<os::WritableFile> file, FaultyDisk& disk)
      : file_(std::move(file)), disk_(disk) {}

  [[nodiscard]] const std::string& name() const noexcept override { return file_->name(); }
  Result<void> WriteAt(std::uint64_t offset,
                       std::span<const std::span<const std::byte>> parts) override {
    const std::scoped_lock wait(disk_.gate);
    if (disk_.failure.empty()) return file_->WriteAt(offset, parts);
    if (disk_.leaves_halves && parts.size() > 1) {
      const std::array half{parts[0], parts[1].first(parts[1].size() / 2)};
      EXPECT_TRUE(file_->WriteAt(offset, half));
    }
    return Error{ErrorCode::kFailed, disk_.failure};
  }
  Result<void> Reserve(std::uint64_t offset, std::uint64_t length) override {
    return file_->Reserve(offset, length);
  }
  Result<void> Truncate(std::uint64_t size) override {
    const std::scoped_lock wait(disk_.gate);
    if (!disk_.failure.empty()) return Error{ErrorCode::kFailed, disk_.failure};
    return file_->Truncate(size);
  }
  Result<void> Sync() override {
    const std::scoped_lock wait(disk_.gate);
    if (!disk_.can_sync) return Error{ErrorCode::kFailed, "Input/output error"};
    return file_->Sync();
  }

 private:
  const std::unique_ptr<os::WritableFile> file_;
  FaultyDisk& disk_;
};

/// So little room for what waits for the disk that losses begin soon.
inline constexpr std::size_t kFewBytes = 20'000;

using CreateFile = decltype(FileOptions::create);

inline FileOptions On(FaultyDisk& disk, const CreateFile& create = &os::CreateWritableFile) {
  FileOptions options;
  options.create =
      [&disk,
       create](const std::filesystem::path& path) -> Result<std::unique_ptr<os::WritableFile>> {
    auto file = create(path);
    if (!file) return file.error();
    std::unique_ptr<os::WritableFile> faulty =
        std::make_unique<FileOnFaultyDisk>(*std::move(file), disk);
    return faulty;
  };
  return options;
}

/// Writes the file to memory. Lock `disk.gate` to read `memory` while it is written.
inline FileOptions On(FaultyDisk& disk, const std::shared_ptr<test::MemoryDisk>& memory) {
  return On(disk, [memory](const std::filesystem::path&) {
    std::unique_ptr<os::WritableFile> file = std::make_unique<test::MemoryWritableFile>(memory);
    return Result<std::unique_ptr<os::WritableFile>>(std::move(file));
  });
}

/// Returns the difference of the two clocks in a recording, in ns: a log time minus this difference
/// is a time of the steady clock.
inline std::int64_t WallMinusSteadyIn(mcap::Reader& reader) {
  for (const mcap::MetadataIndex& index : reader.metadata()) {
    if (index.name != kAboutMetadata) continue;
    const auto about = reader.ReadMetadata(index);
    if (about) return std::stoll(about->metadata.at("wall_minus_steady_ns"));
  }
  ADD_FAILURE() << "the recording has no description";
  return 0;
}

/// A GCM and processes with an odometer each, over loopback.
class RecorderTest : public testing::Test {
 protected:
  RecorderTest() { StartGcm("127.0.0.1:0"); }

  std::shared_ptr<Middleware> Node() { return std::make_shared<LoopbackMiddleware>(network_); }
  void StartGcm(const std::string& address) {
    auto gcm = GlobalManager::Start(Node(), {.address = address, .state_folder = folder_.path()});
    ASSERT_TRUE(gcm) << gcm.error().message;
    gcm_ = *std::move(gcm);
    address_ = gcm_->address();
  }
  std::unique_ptr<Process> StartProcess(const std::string& name) {
    auto process =
        std::make_unique<Process>(name, ProcessOptions{.middleware = Node(), .gcm = address_});
    process->Add<Odometer>("odometer");
    EXPECT_TRUE(process->StartAll());
    return process;
  }
  /// Waits until the catalogue has the running components of these processes.
  void StartRecorder(RecorderOptions options, const std::vector<std::string>& processes,
                     std::size_t most_waiting = RecordingQueue::kMaxBytes) {
    queue_ = std::make_shared<RecordingQueue>(most_waiting);
    client_ = std::make_unique<GcmClient>(
        Node(), GcmClient::Options{.name = "gcm record", .address = address_}, queue_);
    ASSERT_TRUE(client_->WaitUntilWatching());
    ASSERT_TRUE(EventuallyTrue([&] {
      const Catalogue catalogue = client_->catalogue();
      return std::ranges::all_of(processes, [&](const std::string& process) {
        return catalogue.FindComponent(process, "odometer") != nullptr;
      });
    }));
    options.files.file = file_;
    auto recorder = Recorder::Start(*client_, queue_, std::move(options));
    ASSERT_TRUE(recorder) << recorder.error().message;
    recorder_ = *std::move(recorder);
  }
  [[nodiscard]] bool EventuallyRows(std::uint64_t rows) const {
    return EventuallyTrue([&] { return recorder_->status().counts.rows >= rows; });
  }
  /// From now on, the column `Half` of `robot` is negative.
  void Reverse() {
    const auto done = Wait<std::string>(std::chrono::seconds(10), [&](auto handler) {
      client_->Call("robot/odometer/Control.Reverse", "", handler);
    });
    EXPECT_TRUE(done) << done.error().message;
  }
  std::unique_ptr<mcap::Reader> Open() {
    auto reader = mcap::Reader::Open(file_);
    EXPECT_TRUE(reader) << reader.error().message;
    if (!reader) return nullptr;
    EXPECT_EQ(mcap::FlawsOf(**reader), "");
    return *std::move(reader);
  }
  static std::map<std::string, std::vector<mcap::StoredMessage>> ByTopic(mcap::Reader& reader) {
    std::map<std::string, std::vector<mcap::StoredMessage>> all;
    for (auto& message : mcap::ReadAll(reader, {.order = mcap::Query::Order::kFile})) {
      all[message.topic].push_back(std::move(message));
    }
    return all;
  }
  [[nodiscard]] LostRows LostRowsUpToNow() const { return recorder_->status().losses.all_rows(); }
  /// Each row is there once, with its own value, and all that are missing were counted.
  void ExpectEachRowOnce(const std::vector<mcap::StoredMessage>& messages) const {
    ASSERT_FALSE(messages.empty());
    const auto row_of = [](const auto& message) { return ValueOf<std::uint64_t>(message); };
    std::uint64_t missing = 0;
    for (std::size_t i = 1; i < messages.size(); ++i) {
      const std::uint32_t step = messages[i].sequence - messages[i - 1].sequence;
      ASSERT_GE(step, 1U) << "message " << i;
      ASSERT_GT(messages[i].log_time, messages[i - 1].log_time);
      ASSERT_EQ(row_of(messages[i]) - row_of(messages[i - 1]), step);
      missing += step - 1;
    }
    EXPECT_LE(missing, LostRowsUpToNow().all());
  }

  const std::shared_ptr<LoopbackNetwork> network_ = std::make_shared<LoopbackNetwork>();
  const test::Folder folder_;
  const std::filesystem::path file_ = folder_.path() / "run.mcap";
  std::unique_ptr<GlobalManager> gcm_;
  std::string address_;
  std::shared_ptr<RecordingQueue> queue_;
  std::unique_ptr<GcmClient> client_;
  std::unique_ptr<Recorder> recorder_;
};

/// The value in the newest row of an odometer.
inline std::uint64_t NumberOf(const Process& process) {
  std::uint64_t number = 0;
  const auto* const table = process.Find("odometer")->tables().front();
  const auto* const column = dynamic_cast<const Column<std::uint64_t>*>(table->Find("Number"));
  EXPECT_NE(column, nullptr);
  if (column != nullptr) (void)column->ReadNewest(number);
  return number;
}

}  // namespace tendon::recording
