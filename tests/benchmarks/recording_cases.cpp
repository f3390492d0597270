#include <benchmarks/measurement.h>
#include <benchmarks/ram_folder.h>
#include <benchmarks/seat.h>
#include <malloc.h>
#include <tendon/recording/mcap/compression.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/mcap/writer.h>

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tendon::benchmark {
namespace {

constexpr double kMega = 1e6;

/// Throws if the operation has failed, because there is then nothing to measure.
void RequireDone(const Result<void>& done) {
  if (!done) throw std::runtime_error(done.error().message);
}
template <typename T>
T Required(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return *std::move(result);
}

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

/// Makes a sparse file of this size with chunks of 1 MiB. Only the beginning and the end of the
/// file are on the disk; Open() reads nothing else.
std::filesystem::path MakeLargeFile(const RamFolder& folder, std::uint64_t size) {
  constexpr std::uint64_t kChunk = std::uint64_t{1} << 20U;
  constexpr mcap::ChannelId kChannels = 100;
  constexpr std::uint64_t kMessages = 80;  // of each channel in each chunk
  const std::filesystem::path path = folder.path() / "large.mcap";
  const auto file = Required(os::CreateWritableFile(path));
  mcap::Buffer begin(mcap::Magic().begin(), mcap::Magic().end());
  Append(begin, mcap::Header{"ros2", "report"});
  RequireDone(file->WriteAt(0, std::array{mcap::ByteView(begin)}));

  const std::uint64_t chunks = size / kChunk;
  const std::uint64_t data_end = begin.size() + chunks * kChunk;
  mcap::Buffer end;
  Append(end, mcap::DataEnd{});
  const std::size_t summary = end.size();
  mcap::Statistics statistics{.message_count = chunks * kChannels * kMessages,
                              .channel_count = kChannels,
                              .chunk_count = static_cast<std::uint32_t>(chunks),
                              .message_end_time = chunks};
  for (mcap::ChannelId id = 1; id <= kChannels; ++id) {
    Append(end, mcap::Channel{id, 0, "robot/arm/state/Signal" + std::to_string(id), "cdr", {}});
    statistics.channel_message_counts[id] = chunks * kMessages;
  }
  Append(end, statistics);
  for (std::uint64_t i = 0; i < chunks; ++i) {
    constexpr std::uint64_t kIndexes = kChannels * (15 + 16 * kMessages);  // bytes
    mcap::ChunkIndex index{.message_start_time = i,
                           .message_end_time = i + 1,
                           .chunk_start_offset = begin.size() + i * kChunk,
                           .chunk_length = kChunk - kIndexes,
                           .message_index_length = kIndexes,
                           .compressed_size = kChunk - kIndexes - 100,
                           .uncompressed_size = kChunk - kIndexes - 100};
    for (mcap::ChannelId id = 1; id <= kChannels; ++id) {
      index.message_index_offsets.emplace_back(
          id, index.chunk_start_offset + index.chunk_length + (id - 1U) * (15 + 16 * kMessages));
    }
    Append(end, index);
  }
  Append(end, mcap::Footer{data_end + summary, 0, 0});
  constexpr std::size_t kCrcSize = 4;
  end.resize(end.size() - kCrcSize);
  mcap::AppendNumber(end, mcap::Crc32(mcap::ByteView(end).subspan(summary)), kCrcSize);
  end.insert(end.end(), mcap::Magic().begin(), mcap::Magic().end());
  RequireDone(file->WriteAt(data_end, std::array{mcap::ByteView(end)}));
  return path;
}

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

/// Returns a value from /proc/self/status in bytes.
double MemoryFigure(const std::string& name) {
  constexpr double kKibibyte = 1024;
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kibibytes = 0;
    if (word == name + ":" && status >> kibibytes) return kibibytes * kKibibyte;
  }
  return 0;
}

/// The time to open a file, and the peak memory in megabytes during this time.
struct OpenCost {
  double milliseconds = 0;
  double megabytes = 0;
};

OpenCost MeasureOpen(const std::filesystem::path& path) {
  malloc_trim(0);                               // returns the freed memory that this program keeps
  std::ofstream("/proc/self/clear_refs") << 5;  // the peak begins anew
  const double before = MemoryFigure("VmRSS");
  OpenCost cost;
  cost.milliseconds = NanosecondsEach(1,
                                      [&](std::uint64_t) {
                                        const auto reader = Required(mcap::Reader::Open(path));
                                        if (reader->was_scanned())
                                          throw std::runtime_error("there is no index");
                                        cost.megabytes = (MemoryFigure("VmHWM") - before) / kMega;
                                      }) /
                      kMega;
  return cost;
}

}  // namespace

std::vector<Case> RecordingCases(const Effort& effort) {
  constexpr std::uint64_t kLargeFile = 10'000'000'000;
  const auto material = [count = effort.Times(200'000),
                         made = std::make_shared<std::unique_ptr<Material>>()]() -> Material& {
    if (!*made) *made = std::make_unique<Material>(count);
    return **made;
  };
  const auto open = [size = effort.Times(kLargeFile)] {
    const RamFolder folder;
    return MeasureOpen(MakeLargeFile(folder, size));
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
       .what = "opening a recording of 10 GB",
       .unit = "ms",
       .gate = 1000,
       .stretch = 100,
       .repetition = [=] { return std::optional(Pair{.ours = open().milliseconds}); },
       .runs_once = true},
      {.id = "W-mem",
       .what = "the memory that it takes",
       .unit = "MB",
       .gate = 100,
       .stretch = 50,
       .repetition = [=] { return std::optional(Pair{.ours = open().megabytes}); },
       .runs_once = true},
  };
}

}  // namespace tendon::benchmark
