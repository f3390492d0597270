#include <benchmarks/measurement.h>
#include <benchmarks/memory.h>
#include <benchmarks/ram_folder.h>
#include <benchmarks/seat.h>
#include <fcntl.h>
#include <malloc.h>
#include <support/folder.h>
#include <tendon/payload/schema.h>
#include <tendon/recording/mcap/compression.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/mcap/writer.h>
#include <tendon/recording/playback.h>
#include <tendon/recording/recording_format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tendon::benchmark {
namespace {

constexpr double kMega = 1e6;

/// The rows of an arm: seven positions and seven velocities that change as in a real robot.
class ArmRows {
 public:
  explicit ArmRows(std::size_t count) : count_(count), bytes_(count * kSize) {
    for (std::size_t row = 0; row < count; ++row) {
      std::array<double, 14> values{};
      for (std::size_t i = 0; i < values.size(); ++i) {
        // A float has about the resolution of an encoder.
        values[i] = static_cast<float>(
            std::sin(1e-3 * static_cast<double>(row) * static_cast<double>(i + 1)));
      }
      std::byte* const place = bytes_.data() + row * kSize;
      place[1] = std::byte{1};  // little-endian
      std::memcpy(place + 4, values.data(), sizeof(values));
    }
  }

  [[nodiscard]] std::size_t bytes() const { return bytes_.size(); }
  template <typename Visitor>
  void ForEach(Visitor visit) const {
    for (std::size_t row = 0; row < count_; ++row) {
      const mcap::Timestamp time = row * 1'000'000;
      visit(mcap::Message{1, static_cast<std::uint32_t>(row), time, time,
                          mcap::ByteView(bytes_).subspan(row * kSize, kSize)});
    }
  }

 private:
  static constexpr std::size_t kSize = 4 + 14 * sizeof(double);

  const std::size_t count_;
  mcap::Buffer bytes_;
};

/// An uncompressed recording of 100 signals at 1 kHz, of about this size. It is on a disk, and the
/// kernel does not have it in memory, as when a user opens it days later.
class LargeRecording {
 public:
  explicit LargeRecording(std::uint64_t size) {
    const auto writer = Required(mcap::Writer::Create(
        path_, {.profile = recording::kProfile, .compression = mcap::Compression::kNone}));
    const std::string type = SchemaOf<double>().TextWithHelp();
    for (mcap::ChannelId id = 1; id <= kSignals; ++id) {
      const std::string name = "Signal" + std::to_string(id);
      (void)Required(writer->AddChannel(0, recording::TopicOf({"robot", "arm", "state"}, name),
                                        recording::kMessageEncoding,
                                        {{recording::kKindKey, recording::kColumnKind},
                                         {recording::kPathKey, "robot/arm/state." + name},
                                         {recording::kSchemaKey, type}}));
    }
    mcap::Buffer data;
    for (; writer->written().bytes < size; ++rows_) {
      const double value = rows_;
      recording::Encapsulate(std::as_bytes(std::span(&value, 1)), data);
      for (mcap::ChannelId id = 1; id <= kSignals; ++id) {
        RequireDone(writer->Write({id, rows_, TimeOf(rows_), TimeOf(rows_), data}));
      }
    }
    RequireDone(writer->Close());
    const int file = open(path_.c_str(), O_RDONLY | O_CLOEXEC);
    posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED);
    close(file);
  }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::uint32_t rows() const { return rows_; }

  /// Moves to the time of a row and reads the row. Throws if a value is missing or wrong.
  void ReadRow(recording::Playback& playback, std::uint32_t row) const {
    const auto value = static_cast<double>(row);
    mcap::ChannelId right = 0;
    playback.Seek(TimeOf(row));
    playback.Past(playback.columns(), TimeOf(row), recording::Playback::WithLosses::kNo,
                  [&](const recording::PlayedItem& item) {
                    const auto& read = std::get<recording::PlayedValue>(item.content);
                    const bool is_right =
                        std::ranges::equal(read.body, std::as_bytes(std::span(&value, 1)));
                    if (is_right && read.tick == row && item.time == TimeOf(row)) ++right;
                  });
    if (right != kSignals) {
      throw std::runtime_error("row " + std::to_string(row) + " of the large recording has " +
                               std::to_string(right) + " right values; it must have " +
                               std::to_string(kSignals));
    }
  }

 private:
  static constexpr mcap::ChannelId kSignals = 100;

  static mcap::Timestamp TimeOf(std::uint32_t row) {
    return (row + mcap::Timestamp{1}) * 1'000'000;
  }

  const test::Folder folder_;
  const std::filesystem::path path_ = folder_.path() / "large.mcap";
  std::uint32_t rows_ = 0;
};

/// The rows that are recorded repeatedly.
class Material {
 public:
  explicit Material(std::size_t count) : rows_(count) {
    rows_.ForEach([this](const mcap::Message& message) { Append(records_, message); });
  }

  /// Records all rows. Returns the nanoseconds per byte of the rows.
  double Record(mcap::Compression compression) {
    const std::filesystem::path path = folder_.path() / "run.mcap";
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
    const double took = NanosecondsEach(1, [&](std::uint64_t) {
      const auto writer = Required(mcap::Writer::Create(path, {.compression = compression}));
      (void)Required(writer->AddChannel(0, "robot/arm/state/Joints", "cdr"));
      rows_.ForEach([&](const mcap::Message& message) { RequireDone(writer->Write(message)); });
      RequireDone(writer->Close());
    });
    return took / static_cast<double>(rows_.bytes());
  }
  /// Compresses, in one call, the records that Record() would put into chunks. Returns the
  /// nanoseconds per byte of the rows.
  double CompressInOneCall() {
    const double took = NanosecondsEach(1, [&](std::uint64_t) {
      mcap::Compression used = mcap::Compression::kNone;
      auto compressed = zstd_.Compress(records_, used);
      Use(compressed);
    });
    return took / static_cast<double>(rows_.bytes());
  }

 private:
  const RamFolder folder_;
  const ArmRows rows_;
  mcap::Buffer records_;
  mcap::Compressor zstd_{mcap::Compression::kZstd, 1};
};

/// The cost to use a large recording.
struct AccessCost {
  double opening = 0;  // ms
  double seeking = 0;  // ms, to move to a time and read the row there; the slowest of several times
  double memory = 0;   // MB, the peak during all of this
};

AccessCost MeasureAccess(const LargeRecording& large) {
  constexpr int kSeeks = 20;
  malloc_trim(0);                               // returns the freed memory that this program keeps
  std::ofstream("/proc/self/clear_refs") << 5;  // the peak begins anew
  const double before = MemoryFigure("self", "VmRSS");
  AccessCost cost;
  std::unique_ptr<recording::Playback> playback;
  cost.opening = NanosecondsEach(1, [&](std::uint64_t) {
    auto reader = Required(mcap::Reader::Open(large.path()));
    if (reader->was_scanned()) throw std::runtime_error("the large recording has no index");
    playback = Required(recording::Playback::Open(std::move(reader)));
  });
  std::mt19937 random(22);
  std::uniform_int_distribution<std::uint32_t> any(0, large.rows() - 1);
  for (int i = 0; i < kSeeks; ++i) {
    cost.seeking =
        std::max(cost.seeking,
                 NanosecondsEach(1, [&](std::uint64_t) { large.ReadRow(*playback, any(random)); }));
  }
  cost.opening /= kMega;
  cost.seeking /= kMega;
  cost.memory = (MemoryFigure("self", "VmHWM") - before) / kMega;
  return cost;
}

/// Returns the size of the large recording: 10 GB, or half of the disk's room if this is less.
std::uint64_t LargeSize(const Effort& effort) {
  constexpr std::uint64_t kLarge = 10'000'000'000;
  std::error_code unknown;
  const auto room =
      std::filesystem::space(std::filesystem::temp_directory_path(), unknown).available;
  return effort.Times(std::min<std::uint64_t>(kLarge, room / 2));
}

}  // namespace

std::vector<Case> RecordingCases(const Effort& effort) {
  const auto material = [count = effort.Times(200'000),
                         made = std::make_shared<std::unique_ptr<Material>>()]() -> Material& {
    if (!*made) *made = std::make_unique<Material>(count);
    return **made;
  };
  const std::uint64_t size = LargeSize(effort);
  const auto access = [size, cost = std::make_shared<std::optional<AccessCost>>()] {
    if (!*cost) *cost = MeasureAccess(LargeRecording(size));
    return **cost;
  };
  return {
      {.id = "W-rec",
       .what = "recording into a RAM disk, uncompressed",
       .unit = "MB/s",
       .ratio = Ratio::kOfThroughputs,
       .gate = 400,
       .stretch = 1000,
       .repetition =
           [=] {
             const Seat seat(Processor::kFirst);
             return std::optional(Pair{.ours = 1e3 / material().Record(mcap::Compression::kNone)});
           }},
      {.id = "W-zstd",
       .what = "the same with zstd / zstd -1 of the same bytes",
       .unit = "ns/B",
       .ratio = Ratio::kOfThroughputs,
       .gate = 0.7,
       .stretch = 0.9,
       .repetition = SideBySide({[=] { return material().Record(mcap::Compression::kZstd); }},
                                {[=] { return material().CompressInOneCall(); }})},
      {.id = "W-open",
       .what = "opening a recording of " + std::to_string(size / 1'000'000) + " MB",
       .unit = "ms",
       .gate = 1000,
       .stretch = 100,
       .repetition = [=] { return std::optional(Pair{.ours = access().opening}); },
       .runs_once = true},
      {.id = "W-seek",
       .what = "reading the row at a random time, the slowest of 20",
       .unit = "ms",
       .gate = 1000,
       .stretch = 100,
       .repetition = [=] { return std::optional(Pair{.ours = access().seeking}); },
       .runs_once = true},
      {.id = "W-mem",
       .what = "the peak memory of both",
       .unit = "MB",
       .gate = 100,
       .stretch = 50,
       .repetition = [=] { return std::optional(Pair{.ours = access().memory}); },
       .runs_once = true},
  };
}

}  // namespace tendon::benchmark
