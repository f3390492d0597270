#include <gcm_gui/files/file_reader.h>

#include <QFile>
#include <utility>

namespace tendon::gui {

FileReader::FileReader(QObject* parent)
    : QObject(parent), courier_(std::make_shared<Courier>(this)) {}

FileReader::~FileReader() { courier_->detach(); }

void FileReader::read(const QString& name, Done done) {
  thread_.start([courier = courier_, name, done = std::move(done)] {
    QFile file(name);
    const bool is_open = file.open(QIODevice::ReadOnly);
    const QByteArray content = is_open ? file.readAll() : QByteArray();
    const bool is_read = is_open && file.error() == QFileDevice::NoError;
    courier->post([done, content, refusal = is_read ? QString() : file.errorString()] {
      done(refusal.isEmpty() ? content : QByteArray(), refusal);
    });
  });
}

}  // namespace tendon::gui
