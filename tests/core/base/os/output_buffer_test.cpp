#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/base/os/output_buffer.h>
#include <tendon/base/os/termination.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <ostream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

namespace {

using tendon::os::OutputBuffer;

class OutputBufferTest : public testing::Test {
 protected:
  OutputBufferTest() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  }
  ~OutputBufferTest() override {
    for (const int end : ends_) {
      if (end >= 0) close(end);
    }
  }
  void CloseReader() { close(std::exchange(ends_[0], -1)); }
  [[nodiscard]] int writer() const { return ends_[1]; }
  /// Reads to the end. The writer must be closed.
  [[nodiscard]] std::string ReadAll() const {
    std::string all;
    std::array<char, 4096> some{};
    for (ssize_t size = 1; size > 0;) {
      size = read(ends_[0], some.data(), some.size());
      if (size > 0) all.append(some.data(), static_cast<std::size_t>(size));
    }
    return all;
  }
  void CloseWriter() { close(std::exchange(ends_[1], -1)); }

 private:
  std::array<int, 2> ends_{-1, -1};
};

TEST_F(OutputBufferTest, WritesOnFlushOrWhenFull) {
  const std::string much(1'000'000, 'x');
  std::string seen;
  std::thread reader([&] { seen = ReadAll(); });
  {
    OutputBuffer buffer(writer());
    std::ostream out(&buffer);
    out << "one " << 2 << '\n' << std::flush << much << "end";
    EXPECT_TRUE(out.good());
  }
  CloseWriter();
  reader.join();

  EXPECT_EQ(seen, "one 2\n" + much + "end");
}

TEST_F(OutputBufferTest, SetsErrnoIfTheReaderIsGone) {
  tendon::os::HoldTerminationSignals();  // this also ignores SIGPIPE
  CloseReader();
  OutputBuffer buffer(writer());
  std::ostream out(&buffer);

  out << "text" << std::flush;

  EXPECT_FALSE(out.good());
  EXPECT_EQ(errno, EPIPE);
  out.clear();
  errno = 0;
  out << "more" << std::flush;
  EXPECT_FALSE(out.good());
  EXPECT_EQ(errno, EPIPE) << "and ever after";
}

TEST_F(OutputBufferTest, ATerminationRequestEndsABlockedWrite) {
  tendon::os::HoldTerminationSignals();
  OutputBuffer buffer(writer());
  std::ostream out(&buffer);
  const pthread_t self = pthread_self();
  std::thread asker([self] { pthread_kill(self, SIGTERM); });

  out << std::string(10'000'000, 'x') << std::flush;  // nobody reads the pipe

  asker.join();
  EXPECT_FALSE(out.good());
  EXPECT_TRUE(tendon::os::TerminationRequested(std::chrono::milliseconds(0)))
      << "it is still asked";
  tendon::os::HoldTerminationSignals();
}

TEST_F(OutputBufferTest, WritesDoNotBlockAfterATerminationRequest) {
  tendon::os::HoldTerminationSignals();
  OutputBuffer buffer(writer());
  std::ostream out(&buffer);
  pthread_kill(pthread_self(), SIGINT);
  ASSERT_TRUE(tendon::os::TerminationRequested(std::chrono::seconds(1)));

  out << "there is room for this" << std::flush;
  EXPECT_TRUE(out.good());
  out << std::string(10'000'000, 'x') << std::flush;  // nobody reads the pipe

  EXPECT_FALSE(out.good());
  tendon::os::HoldTerminationSignals();
  EXPECT_FALSE(tendon::os::WasTerminationRequested()) << "it goes on";
}

TEST_F(OutputBufferTest, WritesAgainAfterATerminationIsWithdrawn) {
  tendon::os::HoldTerminationSignals();
  OutputBuffer buffer(writer());
  std::ostream out(&buffer);
  pthread_kill(pthread_self(), SIGINT);
  out << std::string(10'000'000, 'x') << std::flush;  // nobody reads the pipe
  ASSERT_FALSE(out.good());
  out.clear();
  out << "too early" << std::flush;
  ASSERT_FALSE(out.good()) << "it is still asked to end";

  ASSERT_TRUE(tendon::os::TerminationRequested(std::chrono::seconds(1)));
  tendon::os::HoldTerminationSignals();
  out.clear();
  out.flush();
  EXPECT_TRUE(out.good()) << "nothing waits to be written";
  std::string seen;
  std::thread reader([&] { seen = ReadAll(); });
  out << "next" << std::flush;

  EXPECT_TRUE(out.good());
  CloseWriter();
  reader.join();
  EXPECT_THAT(seen, testing::EndsWith("xnext"));
}

}  // namespace
