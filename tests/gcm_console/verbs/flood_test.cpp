#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>

#include "gcm_console/system_fixture.h"

namespace {

using nlohmann::json;
using testing::ContainsRegex;
using testing::HasSubstr;

/// Returns the peak of the resident memory so far, in kB.
std::uint64_t PeakMemory(int pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  for (std::string line; std::getline(status, line);) {
    unsigned long kilobytes = 0;
    if (std::sscanf(line.c_str(), "VmHWM: %lu kB", &kilobytes) == 1) return kilobytes;
  }
  return 0;
}

/// The component `room/camera` writes 62 MB per second. The output of a viewer goes to a pipe, and
/// the test decides when to read the pipe.
class FloodTest : public SystemFixture {
 protected:
  void SetUp() override {
    StartGcm();
    room = StartOne("room", "camera", "Camera", "camera");
    ASSERT_TRUE(EventuallySays({"ls", "room"}, "camera\tactive")) << room->err();
    ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
    reader = open(fifo.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    ASSERT_GE(reader, 0);
  }
  ~FloodTest() override {
    if (reader >= 0) close(reader);
  }

  /// Starts gcm; its output is the pipe.
  [[nodiscard]] std::unique_ptr<Program> Begin(const std::string& words) const {
    return std::make_unique<Program>(Program::Words{"/bin/sh", "-c",
                                                    "exec " + Binary("gcm") + " --gcm " + address +
                                                        " --timeout " + kTestTimeout + " " + words +
                                                        " > " + fifo});
  }
  /// Returns the data that is in the pipe now.
  std::string ReadSome() const {
    std::string all;
    std::string some(1U << 16U, '\0');
    for (ssize_t size = 1; size > 0;) {
      size = read(reader, some.data(), some.size());
      if (size > 0) all.append(some, 0, static_cast<std::size_t>(size));
    }
    return all;
  }
  /// Returns the newest tick of the camera, from another viewer that does not receive the pictures.
  [[nodiscard]] std::uint64_t NewestTick() const {
    const Outcome one = Gcm({"watch", "room/camera/state.Frame", "--count", "1"});
    unsigned long tick = 0;
    EXPECT_EQ(std::sscanf(one.out.c_str(), "%*d\t%lu", &tick), 1) << one.out << one.err;
    return tick;
  }
  [[nodiscard]] bool EventuallyMoreRows(std::uint64_t rows) const {
    const std::uint64_t before = NewestTick();
    return EventuallyTrue([&] { return NewestTick() >= before + rows; });
  }

  static constexpr std::uint64_t kMaxMemory = 220 << 10U;  // kB; gcm needs about 120 MB
  static constexpr std::uint64_t kMoreThanFits = 45;       // number of rows of 6.2 MB
  static constexpr std::ptrdiff_t kPixels = std::ptrdiff_t{3} * 1920 * 1080;
  const std::string fifo = (home.path() / "fifo").string();
  std::unique_ptr<Program> room;
  int reader = -1;
};

TEST_F(FloodTest, AViewerWithBlockedOutputUsesBoundedMemory) {
  const auto watch = Begin("--json watch room/camera/state.Image");
  ASSERT_TRUE(EventuallyTrue([&] { return !ReadSome().empty(); })) << watch->err();

  ASSERT_TRUE(EventuallyMoreRows(kMoreThanFits));

  EXPECT_LT(PeakMemory(watch->pid()), kMaxMemory);
  watch->Signal(SIGINT);
  EXPECT_EQ(watch->Wait(), program::kInterrupted) << "it ends although its output is stuck";
  EXPECT_THAT(watch->err(), ContainsRegex("gcm: [0-9]+ rows?, [1-9][0-9]* lost \\("));
}

TEST_F(FloodTest, SigtermEndsAViewerWithBlockedOutput) {
  const auto watch = Begin("watch room/camera/state.Image");
  ASSERT_TRUE(EventuallyTrue([&] { return !ReadSome().empty(); })) << watch->err();
  ASSERT_TRUE(EventuallyMoreRows(3));

  watch->Signal(SIGTERM);

  EXPECT_EQ(watch->Wait(), program::kInterrupted);
}

TEST_F(FloodTest, LostRowsAreSeparateRecordsAndAddUp) {
  const auto watch = Begin("--json watch room/camera/state.Image --count 8");
  std::string all;
  ASSERT_TRUE(EventuallyTrue([&] {
    all += ReadSome();
    return !all.empty();
  })) << watch->err();
  ASSERT_TRUE(EventuallyMoreRows(30));
  ASSERT_TRUE(EventuallyTrue(
      [&] {
        all += ReadSome();
        return watch->Wait(std::chrono::seconds(0)).has_value();
      },
      std::chrono::minutes(10)))
      << watch->err();
  all += ReadSome();

  std::istringstream lines(all);
  std::uint64_t lost = 0;
  std::uint64_t lost_at_first = 0;  // before the first row that arrived
  std::uint64_t rows = 0;
  std::uint64_t first = 0;
  std::uint64_t last = 0;
  std::string order;  // "row 17, lost 3, row 21, "
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(R"({"schema":1,"gap":)")) {
      const json gap = json::parse(line)["gap"];
      EXPECT_EQ(gap["table"], "room/camera/state");
      const auto count = gap["lost_table"].get<std::uint64_t>() +
                         gap["lost_network"].get<std::uint64_t>() +
                         gap["lost_viewer"].get<std::uint64_t>();
      lost += count;
      if (rows == 0) lost_at_first += count;
      order += "lost " + std::to_string(count) + ", ";
      continue;
    }
    ASSERT_TRUE(line.starts_with(R"({"schema":1,"time_ns":)")) << line.substr(0, 200);
    ASSERT_TRUE(line.ends_with("]}}}")) << "a row is whole";
    EXPECT_GE(std::ranges::count(line, ','), kPixels) << "of all its pixels";
    const std::size_t place = line.find(R"("tick":)");
    ASSERT_NE(place, std::string::npos);
    last = std::stoull(line.substr(place + 7));
    if (rows++ == 0) first = last;
    order += "row " + std::to_string(last) + ", ";
  }
  EXPECT_EQ(rows, 8U);
  EXPECT_GT(lost, 0U);
  EXPECT_EQ(rows + lost - lost_at_first, last - first + 1)
      << "each row is there, or counted: " << order;
  EXPECT_THAT(watch->err(), HasSubstr("gcm: 8 rows, " + std::to_string(lost) + " lost"));
}

TEST_F(FloodTest, ReportsLostRowsOnStandardErrorWhileRunning) {
  const auto watch = Begin("watch room/camera/state.Image");
  ASSERT_TRUE(EventuallyTrue([&] { return !ReadSome().empty(); })) << watch->err();
  ASSERT_TRUE(EventuallyMoreRows(30));

  EXPECT_TRUE(EventuallyTrue([&] {
    (void)ReadSome();
    return watch->err().find(" lost (") != std::string::npos;
  }));

  EXPECT_THAT(watch->err(), ContainsRegex("gcm: room/camera/state: [0-9]+ rows? (is|are) lost"));
  watch->Signal(SIGINT);
  EXPECT_EQ(watch->Wait(), program::kInterrupted);
}

TEST_F(FloodTest, LatestCountsNoLosses) {
  const auto watch = Begin("--json watch room/camera/state.Image --latest");
  ASSERT_TRUE(EventuallyTrue([&] { return !ReadSome().empty(); })) << watch->err();
  ASSERT_TRUE(EventuallyMoreRows(kMoreThanFits));

  EXPECT_LT(PeakMemory(watch->pid()), kMaxMemory);
  watch->Signal(SIGINT);
  EXPECT_EQ(watch->Wait(), program::kInterrupted);
  EXPECT_THAT(watch->err(), ContainsRegex("gcm: [0-9]+ rows?, 0 lost"));
}

}  // namespace
