#include <core/recording/recordings.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <support/folder.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <tendon/recording/mcap/writer.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <limits>

namespace tendon::mcap {
namespace {

int lock_failure = 0;   // a value of errno
int failing_locks = 0;  // the next calls of flock() that fail

/// While this object exists, flock() fails, as on a network share without locks. With `calls`, only
/// its next calls fail.
struct FailingLocks {
  explicit FailingLocks(int reason, int calls = std::numeric_limits<int>::max()) {
    lock_failure = reason;
    failing_locks = calls;
  }
  FailingLocks(const FailingLocks&) = delete;
  FailingLocks& operator=(const FailingLocks&) = delete;
  ~FailingLocks() { failing_locks = 0; }
};

}  // namespace
}  // namespace tendon::mcap

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"  // the system has a struct of this name, too
/// Replaces the function of the C library for the whole program.
extern "C" int flock(int descriptor, int operation) noexcept {
  using namespace tendon::mcap;
  if (failing_locks == 0) return static_cast<int>(syscall(SYS_flock, descriptor, operation));
  --failing_locks;
  errno = lock_failure;
  return -1;
}
#pragma GCC diagnostic pop

namespace tendon::mcap {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kSmallChunk = std::size_t{4} << 10U;  // bytes

class WriterTest : public testing::TestWithParam<Compression> {};

INSTANTIATE_TEST_SUITE_P(, WriterTest,
                         testing::Values(Compression::kNone, Compression::kLz4, Compression::kZstd),
                         [](const auto& compression) {
                           return std::string(NameOf(compression.param));
                         });

TEST_P(WriterTest, ARecordingReadsAsItWasWritten) {
  const Sample sample(GetParam());

  const auto reader = Open(sample.bytes);

  EXPECT_FALSE(reader->was_scanned());
  EXPECT_EQ(reader->header(), (Header{"ros2", "test"}));
  EXPECT_EQ(ReadAll(*reader), sample.messages);
  ASSERT_EQ(reader->schemas().size(), 1U);
  EXPECT_EQ(reader->schemas().at(1),
            (Schema{1, "arm/msg/Joints", "ros2msg", "float64[7] position\n"}));
  EXPECT_EQ(
      reader->channels().at(1),
      (Channel{1, 1, "robot/arm/state/Joints", "cdr", {{"unit", "rad"}, {"period", "1 ms"}}}));
  EXPECT_EQ(reader->channels().at(2), (Channel{2, 0, "robot/arm/log", "json", {}}));
  ASSERT_EQ(reader->attachments().size(), 1U);
  const auto attachment = reader->ReadAttachment(reader->attachments()[0]);
  ASSERT_TRUE(attachment) << attachment.error().message;
  EXPECT_EQ(*attachment, sample.attachment);
  ASSERT_EQ(reader->metadata().size(), 1U);
  const auto metadata = reader->ReadMetadata(reader->metadata()[0]);
  ASSERT_TRUE(metadata) << metadata.error().message;
  EXPECT_EQ(*metadata, sample.metadata);
  EXPECT_EQ(FlawsOf(*reader), "");
}

TEST_P(WriterTest, TheStatisticsCountWhatIsInTheFile) {
  const Sample sample(GetParam());

  const auto reader = Open(sample.bytes);

  ASSERT_TRUE(reader->statistics());
  const Statistics& statistics = *reader->statistics();
  EXPECT_EQ(statistics.message_count, sample.messages.size());
  EXPECT_EQ(statistics.schema_count, 1);
  EXPECT_EQ(statistics.channel_count, 2U);
  EXPECT_EQ(statistics.attachment_count, 1U);
  EXPECT_EQ(statistics.metadata_count, 1U);
  EXPECT_EQ(statistics.chunk_count, reader->blocks().size());
  EXPECT_GT(statistics.chunk_count, 5U);
  EXPECT_EQ(statistics.message_start_time, sample.messages.front().log_time);
  EXPECT_EQ(statistics.message_end_time, sample.messages.back().log_time);
  EXPECT_THAT(statistics.channel_message_counts,
              testing::ElementsAre(testing::Pair(1, 320), testing::Pair(2, 80)));
}

TEST(Writer, AFileWithoutMessagesReads) {
  MemoryRecording recording;
  ASSERT_TRUE(recording.writer->Close());

  const auto reader = Open(recording.disk->bytes);

  EXPECT_TRUE(ReadAll(*reader).empty());
  EXPECT_EQ(FlawsOf(*reader), "");
}

TEST(Writer, AChunkIsWrittenWhenItIsFull) {
  MemoryRecording recording({.compression = Compression::kNone, .chunk_size = kSmallChunk});
  const ChannelId channel = *recording.writer->AddChannel(0, "a", "cdr");
  const std::string data(1000, 'x');

  for (int i = 0; i < 3; ++i)
    ASSERT_TRUE(recording.writer->Write({.channel_id = channel, .data = BytesOf(data)}));
  EXPECT_EQ(recording.writer->written().messages, 0U);
  EXPECT_EQ(recording.writer->accepted().messages, 3U);
  ASSERT_TRUE(recording.writer->Write({.channel_id = channel, .data = BytesOf(data)}));

  EXPECT_EQ(recording.writer->written().messages, 3U);
  EXPECT_EQ(recording.writer->synced().messages, 0U);
}

TEST(Writer, AMessageLargerThanAChunkHasAChunkOfItsOwn) {
  MemoryRecording recording({.chunk_size = kSmallChunk});
  const ChannelId channel = *recording.writer->AddChannel(0, "a", "cdr");
  const std::string large(100'000, 'y');

  ASSERT_TRUE(
      recording.writer->Write({.channel_id = channel, .log_time = 1, .data = BytesOf("1")}));
  ASSERT_TRUE(
      recording.writer->Write({.channel_id = channel, .log_time = 2, .data = BytesOf(large)}));
  ASSERT_TRUE(
      recording.writer->Write({.channel_id = channel, .log_time = 3, .data = BytesOf("3")}));
  ASSERT_TRUE(recording.writer->Close());

  const auto reader = Open(recording.disk->bytes);
  EXPECT_EQ(reader->blocks().size(), 3U);
  const auto messages = ReadAll(*reader);
  ASSERT_EQ(messages.size(), 3U);
  EXPECT_EQ(messages[1].data, large);
}

TEST(Writer, SyncMakesEverythingBeforeItReadable) {
  MemoryRecording recording;
  const ChannelId channel = *recording.writer->AddChannel(0, "a", "cdr");
  ASSERT_TRUE(
      recording.writer->Write({.channel_id = channel, .log_time = 5, .data = BytesOf("1")}));

  ASSERT_TRUE(recording.writer->Sync());

  EXPECT_EQ(recording.disk->syncs, 1U);
  EXPECT_EQ(recording.writer->synced(), recording.writer->written());
  EXPECT_EQ(recording.writer->synced().messages, 1U);
  EXPECT_EQ(recording.writer->synced().last_log_time, 5U);
  const auto reader = Open(recording.disk->bytes);
  EXPECT_EQ(ReadAll(*reader).size(), 1U);
  ASSERT_TRUE(recording.writer->Sync());
  EXPECT_EQ(recording.disk->syncs, 1U) << "nothing was new";
}

TEST(Writer, ARefusedArgumentIsNamedAndChangesNothing) {
  MemoryRecording recording;
  Writer& writer = *recording.writer;
  const ChannelId channel = *writer.AddChannel(0, "a", "cdr");

  const auto unknown_channel = writer.Write({.channel_id = 2});
  const auto no_channel = writer.Write({.channel_id = 0});
  const auto unknown_schema = writer.AddChannel(1, "b", "cdr");
  const auto large = writer.AddSchema("s", "ros2msg", std::string(Writer::kLargestText + 1, ' '));

  ASSERT_FALSE(unknown_channel);
  EXPECT_EQ(unknown_channel.error().message,
            "cannot write a message to memory.mcap: channel 2 is unknown; add this channel first");
  EXPECT_FALSE(no_channel);
  ASSERT_FALSE(unknown_schema);
  EXPECT_EQ(unknown_schema.error().message,
            "cannot add channel 'b': schema 1 is unknown; add this schema first");
  ASSERT_FALSE(large);
  EXPECT_EQ(large.error().code, ErrorCode::kInvalid);
  ASSERT_TRUE(writer.Write({.channel_id = channel}));
  ASSERT_TRUE(writer.Close());
  EXPECT_EQ(FlawsOf(*Open(recording.disk->bytes)), "");
}

TEST(Writer, NothingIsWrittenAfterItIsClosed) {
  MemoryRecording recording;
  const ChannelId channel = *recording.writer->AddChannel(0, "a", "cdr");
  ASSERT_TRUE(recording.writer->Close());

  const auto written = recording.writer->Write({.channel_id = channel});

  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().message,
            "cannot write to memory.mcap: the file is closed; create another file");
  EXPECT_TRUE(recording.writer->Close()) << "a second time";
}

TEST(Writer, AFileHasAtMost65535Channels) {
  MemoryRecording recording;
  for (int i = 0; i < 65'535; ++i) ASSERT_TRUE(recording.writer->AddChannel(0, "t", "cdr"));

  const auto more = recording.writer->AddChannel(0, "one", "cdr");

  ASSERT_FALSE(more);
  EXPECT_EQ(more.error().message,
            "cannot add channel 'one': a file has at most 65,535 channels; begin another file");
  ASSERT_TRUE(recording.writer->Write({.channel_id = 65'535, .data = BytesOf("last")}));
  ASSERT_TRUE(recording.writer->Close());
  const auto reader = Open(recording.disk->bytes);
  EXPECT_EQ(reader->channels().size(), 65'535U);
  EXPECT_EQ(ReadAll(*reader).size(), 1U);
}

TEST(Writer, AnIndexThatIsFullIsAnErrorAndTheFileIsCompleted) {
  MemoryRecording recording({.chunk_size = kSmallChunk, .largest_index = 2000});
  const ChannelId channel = *recording.writer->AddChannel(0, "a", "cdr");
  const std::string data(4000, 'x');
  Result<void> written;
  std::size_t count = 0;
  while (written && count < 100) {
    written = recording.writer->Write({.channel_id = channel, .data = BytesOf(data)});
    if (written) ++count;
  }

  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, testing::HasSubstr("close the file and begin another"));
  ASSERT_TRUE(recording.writer->Close());
  EXPECT_EQ(ReadAll(*Open(recording.disk->bytes)).size(), count);
}

/// Writes until the disk refuses. Returns the error, and checks that everything before it can be
/// read.
std::string FillTheDisk(MemoryRecording& recording) {
  Writer& writer = *recording.writer;
  const ChannelId channel = *writer.AddChannel(0, "a", "cdr");
  const std::string data(100, 'x');
  Result<void> written;
  Timestamp time = 0;
  while (written && time < 100'000) {
    written = writer.Write({.channel_id = channel, .log_time = ++time, .data = BytesOf(data)});
  }
  EXPECT_FALSE(written);
  const std::uint64_t safe = writer.written().messages;
  EXPECT_GT(safe, 0U);

  const auto again = writer.Write({.channel_id = channel, .log_time = time, .data = BytesOf(data)});
  EXPECT_FALSE(again);
  EXPECT_EQ(again.error(), written.error());
  EXPECT_FALSE(writer.Close());

  EXPECT_EQ(ReadAll(*Open(recording.disk->bytes)).size(), safe);
  return written.error().message;
}

TEST(Writer, AFullDiskIsToldWithWhatIsSafe) {
  MemoryRecording recording({.compression = Compression::kNone, .chunk_size = kSmallChunk});
  recording.disk->capacity = 50'000;

  const std::string error = FillTheDisk(recording);

  EXPECT_THAT(
      error,
      testing::MatchesRegex(
          "recording stopped: cannot write at [0-9]+ of memory.mcap: No space left on device \\(0 "
          "B free\\); [0-9]+ messages up to 0.000 s are in the file; the [0-9]+ later messages are "
          "lost; free space or check the disk, then record into another file"));
}

TEST(Writer, AFileOnAFullDiskStillGetsItsIndex) {
  MemoryRecording recording({.compression = Compression::kNone, .chunk_size = kSmallChunk});
  recording.disk->capacity = 50'000;

  FillTheDisk(recording);

  const auto reader = Open(recording.disk->bytes);
  EXPECT_FALSE(reader->was_scanned());
  EXPECT_EQ(FlawsOf(*reader), "");
}

TEST(Writer, AFileOnADiskWithoutReservationsEndsAtItsLastChunk) {
  MemoryRecording recording({.compression = Compression::kNone, .chunk_size = kSmallChunk});
  recording.disk->capacity = 46'700;  // too small for an index after the last chunk
  recording.disk->can_reserve = false;

  FillTheDisk(recording);

  const auto reader = Open(recording.disk->bytes);
  EXPECT_TRUE(reader->was_scanned());
  EXPECT_EQ(recording.disk->bytes.size(), recording.writer->written().bytes);
}

TEST(Writer, ADiskThatFailsWhileSyncingIsTold) {
  MemoryRecording recording;
  const ChannelId channel = *recording.writer->AddChannel(0, "a", "cdr");
  const auto write = [&](int messages) {
    for (int i = 0; i < messages; ++i) {
      ASSERT_TRUE(recording.writer->Write({.channel_id = channel}));
    }
  };
  write(3);
  ASSERT_TRUE(recording.writer->Sync());
  write(2);
  recording.disk->can_sync = false;

  const auto synced = recording.writer->Sync();

  ASSERT_FALSE(synced);
  EXPECT_EQ(synced.error().message,
            "recording stopped: cannot write memory.mcap to the disk: Input/output error; 3 "
            "messages up to 0.000 s are on the disk; the 2 later messages may be lost; check the "
            "disk, then record into another file");
  EXPECT_EQ(recording.writer->synced().messages, 3U);
  EXPECT_EQ(ReadAll(*Open(recording.disk->synced)).size(), 3U);
  EXPECT_FALSE(recording.writer->Close());
}

TEST(WriterOnDisk, NeverReplacesAFile) {
  const test::Folder folder;
  folder.Write("run.mcap", "precious");

  const auto writer = Writer::Create(folder.path() / "run.mcap");

  ASSERT_FALSE(writer);
  EXPECT_EQ(writer.error().code, ErrorCode::kExists);
  EXPECT_EQ(writer.error().message,
            (folder.path() / "run.mcap").string() +
                " already exists, and a recording never replaces a file, because another program "
                "may still be writing it: choose another name");
  EXPECT_EQ(folder.Read("run.mcap"), "precious");
}

TEST(WriterOnDisk, SaysThatAnotherProgramIsRecordingIntoTheFile) {
  const test::Folder folder;
  const fs::path file = folder.path() / "run.mcap";
  auto first = Writer::Create(file);
  ASSERT_TRUE(first) << first.error().message;

  const auto during = Writer::Create(file);
  first->reset();
  const auto after = Writer::Create(file);

  ASSERT_FALSE(during);
  EXPECT_EQ(during.error().code, ErrorCode::kExists);
  EXPECT_EQ(during.error().message, file.string() +
                                        " is being recorded: choose another name, or stop "
                                        "that recording first");
  ASSERT_FALSE(after);
  EXPECT_THAT(after.error().message, testing::HasSubstr(" already exists, and a recording never"));
}

TEST(WriterOnDisk, RecordsOnANetworkShareWithoutLocks) {
  for (const int reason : {ENOLCK, EOPNOTSUPP, EINTR}) {
    SCOPED_TRACE(reason);
    const test::Folder folder;
    const fs::path file = folder.path() / "run.mcap";
    const FailingLocks share(reason);

    auto writer = Writer::Create(file);
    ASSERT_TRUE(writer) << writer.error().message;
    const ChannelId channel = *(*writer)->AddChannel(0, "a", "cdr");
    ASSERT_TRUE((*writer)->Write({.channel_id = channel, .log_time = 7, .data = BytesOf("x")}));
    ASSERT_TRUE((*writer)->Sync());
    const auto second = Writer::Create(file);
    const auto early = Reader::Open(file);
    ASSERT_TRUE((*writer)->Close());
    const auto late = Reader::Open(file);

    ASSERT_TRUE(early && late);
    EXPECT_FALSE((*early)->is_being_written());
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().code, ErrorCode::kExists);
    EXPECT_THAT(second.error().message, testing::HasSubstr("may still be writing it"));
    EXPECT_EQ(ReadAll(**early).size(), 1U);
    EXPECT_EQ(FlawsOf(**late), "");
  }
}

TEST(WriterOnDisk, LocksAFileWhoseLockAReaderIsChecking) {
  const test::Folder folder;
  const fs::path file = folder.path() / "run.mcap";
  const FailingLocks reader(EWOULDBLOCK, 3);

  const auto writer = Writer::Create(file);

  ASSERT_TRUE(writer) << writer.error().message;
  EXPECT_TRUE((*os::OpenRandomAccessFile(file))->is_being_written());
}

TEST(WriterOnDisk, AReaderSeesThatAFileIsBeingWritten) {
  const test::Folder folder;
  const fs::path file = folder.path() / "run.mcap";
  auto writer = Writer::Create(file);
  ASSERT_TRUE(writer) << writer.error().message;
  const auto opened = os::OpenRandomAccessFile(file);
  ASSERT_TRUE(opened);

  EXPECT_TRUE((*opened)->is_being_written());
  ASSERT_TRUE((*writer)->Close());
  writer->reset();
  EXPECT_FALSE((*opened)->is_being_written());
}

/// Runs `write` in a child process, because it may end the process. Returns how the child ended.
template <typename Write>
int InAChild(const Write& write) {
  const pid_t child = fork();
  if (child == 0) _exit(write());
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

/// Writes messages of 100 bytes until the file refuses them, and then closes the file. Returns an
/// exit code.
int WriteUntilRefused(const fs::path& file, std::uint64_t most) {
  auto writer =
      Writer::Create(file, {.compression = Compression::kNone, .chunk_size = kSmallChunk});
  if (!writer) return 2;
  const auto channel = (*writer)->AddChannel(0, "a", "cdr");
  if (!channel) return 3;
  const std::string data(100, 'x');
  Result<void> written;
  Timestamp time = 0;
  while (written && time < most) {
    written = (*writer)->Write({.channel_id = *channel, .log_time = ++time, .data = BytesOf(data)});
  }
  static_cast<void>((*writer)->Close());
  return written ? 4 : 0;
}

TEST(WriterOnDisk, AFileOfTheLargestAllowedSizeReads) {
  const test::Folder folder;
  const fs::path file = folder.path() / "run.mcap";
  const int status = InAChild([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{100'000, 100'000};
    if (setrlimit(RLIMIT_FSIZE, &limit) != 0) return 5;
    return WriteUntilRefused(file, 10'000);
  });

  ASSERT_EQ(status, 0);
  const auto reader = Reader::Open(file);
  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_GT(ReadAll(**reader).size(), 600U);
}

TEST(WriterOnDisk, AFileOnAFullRamDiskGetsItsIndex) {
  const test::Folder folder;
  const fs::path disk = folder.path() / "disk";
  const fs::path copy = folder.path() / "copy.mcap";
  fs::create_directory(disk);
  constexpr int kNoMount = 77;
  const int status = InAChild([&] {
    if (unshare(CLONE_NEWNS) != 0 && unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return kNoMount;
    mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr);
    if (mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=1m") != 0) return kNoMount;
    const int written = WriteUntilRefused(disk / "run.mcap", 100'000);
    std::error_code failed;
    fs::copy_file(disk / "run.mcap", copy, failed);
    return failed ? 6 : written;
  });
  if (WIFEXITED(status) && WEXITSTATUS(status) == kNoMount) {
    GTEST_SKIP() << "this user may not mount a RAM disk";
  }

  ASSERT_EQ(status, 0);
  const auto reader = Reader::Open(copy);
  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_FALSE((*reader)->was_scanned());
  EXPECT_GT(ReadAll(**reader).size(), 6000U);
  EXPECT_EQ(FlawsOf(**reader), "");
}

TEST(WriterOnDisk, AllCompleteChunksAreReadAfterSigkill) {
  const test::Folder folder;
  for (const std::uint64_t count : {50U, 333U, 1000U}) {
    const fs::path file = folder.path() / std::to_string(count);
    const int status = InAChild([&] {
      auto writer =
          Writer::Create(file, {.compression = Compression::kNone, .chunk_size = kSmallChunk});
      const auto channel = (*writer)->AddChannel(0, "a", "cdr");
      for (Timestamp time = 0; time < count; ++time) {
        static_cast<void>((*writer)->Write(
            {.channel_id = *channel, .log_time = time, .data = BytesOf(std::string(100, 'x'))}));
      }
      return raise(SIGKILL);
    });

    ASSERT_TRUE(WIFSIGNALED(status));
    const auto reader = Reader::Open(file);
    ASSERT_TRUE(reader) << reader.error().message;
    constexpr std::uint64_t kPerChunk = 31;
    const auto messages = ReadAll(**reader);
    EXPECT_GE(messages.size() + kPerChunk, count);
    EXPECT_THAT(Sentences(**reader), testing::HasSubstr("the recording was cut off"));
  }
}

}  // namespace
}  // namespace tendon::mcap
