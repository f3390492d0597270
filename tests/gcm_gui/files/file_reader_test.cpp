#include <fcntl.h>
#include <gcm_gui/files/file_reader.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <memory>
#include <optional>

namespace tendon::gui {
namespace {

constexpr int kReaderTimeout = 120'000;  // ms

struct Read {
  QByteArray content;
  QString refusal;
};

class FileReaderTest : public ::testing::Test {
 protected:
  FileReader::Done Keep() {
    return [this](const QByteArray& content, const QString& refusal) {
      read_ = {content, refusal};
    };
  }

  const QTemporaryDir folder_;
  std::optional<Read> read_;
};

TEST_F(FileReaderTest, ReadsAsynchronously) {
  const QString name = folder_.filePath("plots.json");
  QFile file(name);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write("{}") == 2);
  file.close();
  FileReader reader;

  reader.read(name, Keep());
  EXPECT_FALSE(read_);

  ASSERT_TRUE(QTest::qWaitFor([this] { return read_.has_value(); }, kReaderTimeout));
  EXPECT_EQ(read_->content, "{}");
  EXPECT_TRUE(read_->refusal.isEmpty());
}

TEST_F(FileReaderTest, ReportsAReadError) {
  FileReader reader;

  reader.read(folder_.filePath("none"), Keep());

  ASSERT_TRUE(QTest::qWaitFor([this] { return read_.has_value(); }, kReaderTimeout));
  EXPECT_TRUE(read_->content.isEmpty());
  EXPECT_FALSE(read_->refusal.isEmpty());
}

/// A pipe to which no program writes acts like a very slow disk.
TEST_F(FileReaderTest, ASlowFileDoesNotBlockTheCaller) {
  const QString pipe = folder_.filePath("pipe");
  ASSERT_EQ(::mkfifo(pipe.toLocal8Bit().constData(), 0600), 0);
  FileReader reader;

  reader.read(pipe, Keep());

  EXPECT_FALSE(read_);
  int end = -1;  // opening fails until there is a reader
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        end = ::open(pipe.toLocal8Bit().constData(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
        return end >= 0;
      },
      kReaderTimeout));
  EXPECT_EQ(::write(end, "late", 4), 4);
  ::close(end);
  ASSERT_TRUE(QTest::qWaitFor([this] { return read_.has_value(); }, kReaderTimeout));
  EXPECT_EQ(read_->content, "late");
}

TEST_F(FileReaderTest, TheDestructorDoesNotWaitForASlowFile) {
  const QString pipe = folder_.filePath("pipe");
  ASSERT_EQ(::mkfifo(pipe.toLocal8Bit().constData(), 0600), 0);
  auto reader = std::make_unique<FileReader>();
  reader->read(pipe, Keep());
  int end = -1;  // opening fails until the reader has opened the pipe
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        end = ::open(pipe.toLocal8Bit().constData(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
        return end >= 0;
      },
      kReaderTimeout));

  testing::internal::CaptureStderr();
  reader.reset();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "it gave up a reading";

  ::close(end);  // the thread was still reading until now
  QCoreApplication::processEvents();
  EXPECT_FALSE(read_);
}

}  // namespace
}  // namespace tendon::gui
