#include <gcm_gui/files/file_writer.h>
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFile>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>
#include <chrono>
#include <future>
#include <memory>

namespace tendon::gui {
namespace {

constexpr std::chrono::seconds kLong{120};  // bounds a test that fails

class FileWriterTest : public ::testing::Test {
 protected:
  [[nodiscard]] QString Path(const QString& name) const { return folder_.filePath(name); }
  [[nodiscard]] static QByteArray Content(const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("no file");
  }
  FileWriter::Done Hear() {
    return [this](const QString& refusal) { told_.append(refusal); };
  }
  bool HasHeard(qsizetype times) {
    return QTest::qWaitFor([&] { return told_.size() == times; }, 120'000);
  }
  /// Returns a function that acts like a disk that does not respond until `go_` is set.
  FileWriter::Fill Stuck() {
    return [this, go = go_.get_future().share()](QIODevice& file) {
      begun_.set_value();
      go.wait();
      return file.write("late") == 4;
    };
  }

  QTemporaryDir folder_;
  QObject context_;
  QStringList told_;
  std::promise<void> go_;
  std::promise<void> begun_;
};

TEST_F(FileWriterTest, ASlowDiskDoesNotBlockTheCaller) {
  FileWriter writer;
  writer.write(Path("a"), Stuck(), &context_, Hear());

  EXPECT_FALSE(QFile::exists(Path("a")));
  EXPECT_TRUE(told_.isEmpty());
  go_.set_value();

  ASSERT_TRUE(HasHeard(1));
  EXPECT_EQ(told_.front(), QString());
  EXPECT_EQ(Content(Path("a")), "late");
}

TEST_F(FileWriterTest, WritesOnlyTheLastPendingContent) {
  FileWriter writer;
  writer.write(Path("a"), Stuck(), nullptr, {});
  int written = 0;  // set in the writer's thread; read after its notice
  for (const char* content : {"1", "2", "3"}) {
    const auto fill = [&written, content](QIODevice& file) {
      ++written;
      return file.write(content) == 1;
    };
    writer.write(Path("c"), fill, &context_, Hear());
  }
  go_.set_value();

  ASSERT_TRUE(HasHeard(3));
  EXPECT_EQ(told_, (QStringList{"", "", ""}));
  EXPECT_EQ(written, 1);
  EXPECT_EQ(Content(Path("c")), "3");
  EXPECT_EQ(Content(Path("a")), "late");
}

TEST_F(FileWriterTest, AFailedWriteIsReportedAndKeepsTheFile) {
  FileWriter writer;
  writer.write(Path("a"), "before", &context_, Hear());
  ASSERT_TRUE(HasHeard(1));

  const auto half = [](QIODevice& file) {
    file.write("half");
    return false;
  };
  writer.write(Path("a"), half, &context_, Hear());
  writer.write(Path("none/b"), "x", &context_, Hear());

  ASSERT_TRUE(HasHeard(3));
  EXPECT_EQ(told_[0], QString());
  EXPECT_FALSE(told_[1].isEmpty());
  EXPECT_FALSE(told_[2].isEmpty());
  EXPECT_EQ(Content(Path("a")), "before");
}

TEST_F(FileWriterTest, DoesNotNotifyADestroyedContext) {
  FileWriter writer;
  auto context = std::make_unique<QObject>();
  writer.write(Path("a"), Stuck(), context.get(), Hear());
  context.reset();
  writer.write(Path("b"), "x", &context_, Hear());
  go_.set_value();

  ASSERT_TRUE(HasHeard(1));
  EXPECT_EQ(Content(Path("a")), "late");
}

TEST_F(FileWriterTest, PrivateFilesAreReadableByTheOwnerOnly) {
  FileWriter writer;
  writer.write(Path("a"), "x", &context_, Hear(), FileWriter::Readers::kOwner);

  ASSERT_TRUE(HasHeard(1));
  EXPECT_EQ(QFile::permissions(Path("a")) & (QFile::ReadGroup | QFile::ReadOther),
            QFile::Permissions());
}

TEST_F(FileWriterTest, TheDestructorWaitsForPendingWrites) {
  {
    FileWriter writer(nullptr, kLong);
    for (int i = 0; i < 20; ++i) writer.write(Path(QString::number(i)), "x", nullptr, {});
  }

  for (int i = 0; i < 20; ++i) EXPECT_EQ(Content(Path(QString::number(i))), "x") << i;
}

TEST_F(FileWriterTest, TheDestructorTimesOutAndListsUnwrittenFiles) {
  testing::internal::CaptureStderr();
  {
    FileWriter writer(nullptr, std::chrono::milliseconds(20));
    writer.write(Path("a"), Stuck(), &context_, Hear());
    writer.write(Path("b"), "x", &context_, Hear());
    begun_.get_future().wait();
  }
  const std::string said = testing::internal::GetCapturedStderr();

  EXPECT_NE(said.find(Path("a").toStdString() + " was not written"), std::string::npos) << said;
  EXPECT_NE(said.find(Path("b").toStdString() + " was not written"), std::string::npos) << said;
  go_.set_value();
  EXPECT_TRUE(QTest::qWaitFor([this] { return QFile::exists(Path("a")); }, 120'000));
  EXPECT_FALSE(QFile::exists(Path("b")));
  EXPECT_TRUE(told_.isEmpty());
}

TEST_F(FileWriterTest, TheDestructorPrintsUnreportedErrors) {
  const auto is_said = [this](const std::string& said, const char* name) {
    return said.find(Path(name).toStdString() + " was not saved: ") != std::string::npos;
  };
  testing::internal::CaptureStderr();
  {
    FileWriter writer(nullptr, kLong);
    writer.write(Path("none/told"), "x", &context_, Hear());
    EXPECT_TRUE(HasHeard(1));
    writer.write(Path("none/late"), "x", &context_, Hear());
    writer.write(Path("good"), "x", &context_, Hear());
  }
  const std::string said = testing::internal::GetCapturedStderr();

  EXPECT_TRUE(is_said(said, "none/late")) << said;
  EXPECT_FALSE(is_said(said, "none/told")) << said;
  EXPECT_FALSE(is_said(said, "good")) << said;
  EXPECT_EQ(told_.size(), 1);
}

TEST_F(FileWriterTest, ASlowExportDoesNotDelaySmallFiles) {
  FileWriter::exports().write(Path("picture"), Stuck(), nullptr, {});
  FileWriter::instance().write(Path("small"), "x", nullptr, {});

  EXPECT_TRUE(FileWriter::instance().waitForWritten(kLong));
  EXPECT_EQ(Content(Path("small")), "x");
  go_.set_value();
  EXPECT_TRUE(FileWriter::exports().waitForWritten(kLong));
  EXPECT_EQ(Content(Path("picture")), "late");
}

}  // namespace
}  // namespace tendon::gui
