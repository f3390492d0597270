#include <gcm_gui/files/file_reader.h>

#include <gcm_gui/guard/exception_guard.h>

#include <QFile>
#include <utility>

namespace tendon::gui {
namespace {

/// Reads a file. Returns the reason if this fails; empty on success.
QString Read(const QString& name, QByteArray& content) try {
  QFile file(name);
  if (!file.open(QIODevice::ReadOnly)) return file.errorString();
  content = file.readAll();
  return file.error() == QFileDevice::NoError ? QString() : file.errorString();
} catch (...) {
  return CurrentExceptionText();
}

}  // namespace

FileReader::FileReader(QObject* parent)
    : QObject(parent), poster_(std::make_shared<GuiPoster>(this)) {}

FileReader::~FileReader() {
  poster_->detach();
  thread_.dropWaiting();
  thread_.handOver();
}

void FileReader::read(const QString& name, Done done) {
  thread_.start([poster = poster_, name, done = std::move(done)] {
    QByteArray content;
    const QString refusal = Read(name, content);
    poster->post(
        [done, content, refusal] { done(refusal.isEmpty() ? content : QByteArray(), refusal); });
  });
}

}  // namespace tendon::gui
