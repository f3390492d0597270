#include <gcm_gui/files/file_writer.h>
#include <gcm_gui/files/saved_settings.h>
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <chrono>
#include <future>
#include <string>

namespace tendon::gui {
namespace {

constexpr std::chrono::seconds kUntilKept{120};  // bounds a test that fails

TEST(SavedSettings, PersistAcrossInstances) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("below/window.json");
  const QByteArray any("\x00\xff\n\"", 4);
  {
    SavedSettings values(file);
    EXPECT_EQ(values.value("geometry"), QByteArray());
    values.set("geometry", "first");
    values.set("geometry", any);
    values.set("seen", "yes");
    EXPECT_EQ(values.value("geometry"), any);
  }
  ASSERT_TRUE(FileWriter::instance().waitForWritten(kUntilKept));

  const SavedSettings again(file);
  EXPECT_EQ(again.value("geometry"), any);
  EXPECT_EQ(again.value("seen"), "yes");
}

TEST(SavedSettings, IgnoreAForeignFile) {
  const QTemporaryDir folder;
  const QString name = folder.filePath("window.json");
  for (const char* content : {"", "[1]", "{\"values\": 3}", "{\"values\": {\"geometry\": [1]}}"}) {
    QFile file(name);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(content);
    file.close();

    EXPECT_EQ(SavedSettings(name).value("geometry"), QByteArray()) << content;
  }
}

TEST(SavedSettings, ASlowDiskDoesNotBlock) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("window.json");
  std::promise<void> go;
  const auto slow = [answered = go.get_future().share()](QIODevice&) {
    answered.wait();
    return true;
  };
  FileWriter::instance().write(folder.filePath("slow"), slow, nullptr, {});

  { SavedSettings(file).set("geometry", "x"); }

  EXPECT_FALSE(QFile::exists(file));
  go.set_value();
  ASSERT_TRUE(FileWriter::instance().waitForWritten(kUntilKept));
  EXPECT_EQ(SavedSettings(file).value("geometry"), "x");
}

TEST(SavedSettings, TwoProgramsKeepEachOthersSettings) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("window.json");
  SavedSettings first(file);
  SavedSettings second(file);
  first.set("seen", "yes");
  first.set("geometry", "first");
  ASSERT_TRUE(FileWriter::instance().waitForWritten(kUntilKept));

  second.set("geometry", "second");
  ASSERT_TRUE(FileWriter::instance().waitForWritten(kUntilKept));

  const SavedSettings again(file);
  EXPECT_EQ(again.value("seen"), "yes");
  EXPECT_EQ(again.value("geometry"), "second");
}

/// A file that cannot be written, and the messages about it.
class SavedSettingsError : public ::testing::Test {
 protected:
  SavedSettingsError() { EXPECT_TRUE(QDir().mkdir(file_)); }  // a folder with the name of the file
  [[nodiscard]] bool IsSaid(const std::string& text) const {
    return text.find(file_.toStdString() + " was not saved: ") != std::string::npos;
  }

  const QTemporaryDir folder_;
  const QString file_ = folder_.filePath("window.json");
};

TEST_F(SavedSettingsError, IsPrintedOnStderr) {
  testing::internal::CaptureStderr();

  SavedSettings(file_).set("seen", "yes");
  EXPECT_TRUE(FileWriter::instance().waitForWritten(kUntilKept));
  QCoreApplication::processEvents();

  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(IsSaid(said)) << said;
}

TEST_F(SavedSettingsError, IsPrintedAtExit) {
  testing::internal::CaptureStderr();

  SavedSettings(file_).set("seen", "yes");
  delete &FileWriter::instance();  // the application does the same after its event loop

  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(IsSaid(said)) << said;
}

}  // namespace
}  // namespace tendon::gui
