#include <gcm_gui/console/output_pipe.h>
#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>

namespace tendon::gui {
namespace {

TEST(OutputPipe, WakesTheReaderOnceUntilItReads) {
  int wakes = 0;
  OutputPipe pipe([&] { ++wakes; });
  PipeStream out(pipe, OutputPipe::Kind::kOut);
  PipeStream err(pipe, OutputPipe::Kind::kError);

  out << "a" << 1;
  err << "b";

  EXPECT_EQ(wakes, 1);
  const auto pieces = pipe.take();
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].text, "a1");
  EXPECT_EQ(pieces[1].kind, OutputPipe::Kind::kError);
  EXPECT_TRUE(pipe.isEmpty());
}

TEST(OutputPipe, LongOutputIsReadInParts) {
  int wakes = 0;
  OutputPipe pipe([&] { ++wakes; });
  const std::string text(3 * OutputPipe::kMaxTaken, 'x');
  pipe.write(OutputPipe::Kind::kOut, text);

  std::string taken;
  for (int i = 0; i < wakes; ++i) {
    for (const auto& piece : pipe.take()) {
      EXPECT_LE(piece.text.size(), OutputPipe::kMaxTaken);
      taken += piece.text;
    }
  }

  EXPECT_EQ(taken, text);
}

TEST(OutputPipe, AWriterFarAheadWaitsForTheReader) {
  OutputPipe pipe([] {});
  std::atomic<bool> is_done = false;
  std::thread writer([&] {
    for (int i = 0; i < 4; ++i) {
      pipe.write(OutputPipe::Kind::kOut, std::string(OutputPipe::kMaxWaiting, 'x'));
    }
    is_done = true;
  });
  std::size_t taken = 0;
  while (taken < 4 * OutputPipe::kMaxWaiting) {
    for (const auto& piece : pipe.take()) taken += piece.text.size();
  }
  writer.join();

  EXPECT_TRUE(is_done);
}

TEST(OutputPipe, ClosingReleasesAWaitingWriter) {
  OutputPipe pipe([] {});
  ASSERT_TRUE(pipe.write(OutputPipe::Kind::kOut, std::string(OutputPipe::kMaxWaiting, 'x')));
  PipeStream out(pipe, OutputPipe::Kind::kOut);
  std::thread writer([&] { out << "more" << std::flush; });
  pipe.close();
  writer.join();

  EXPECT_FALSE(out.good());
}

}  // namespace
}  // namespace tendon::gui
