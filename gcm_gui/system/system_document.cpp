#include <gcm_gui/models/text.h>
#include <gcm_gui/system/system_document.h>
#include <gcm_gui/system/system_parts.h>
#include <tendon/gcm/system/running_system.h>

#include <QFileInfo>
#include <chrono>
#include <utility>

namespace tendon::gui {
namespace {

constexpr std::chrono::milliseconds kSoon{200};  // many changes come as one

/// What is to be written, or why it is not.
Result<SystemFile> SystemToSave(const std::string& path, RunningSystem running) {
  const auto former = ReadSystemFile(path);
  if (former) {
    running.file.name = former->name;
    (void)KeepFrom(*former, running);
  } else if (former.error().code != ErrorCode::kNotFound) {
    return former.error();
  }
  return std::move(running.file);
}

QString FileName(const QString& path) { return QFileInfo(path).fileName(); }

}  // namespace

SystemDocument::SystemDocument(const CatalogueStore& store, QObject* parent)
    : QObject(parent), store_(store) {
  thread_.setMaxThreadCount(1);
  soon_.setSingleShot(true);
  soon_.setInterval(kSoon);
  connect(&soon_, &QTimer::timeout, this, &SystemDocument::hear);
  connect(&store, &CatalogueStore::changed, this, [this] {
    if (!soon_.isActive()) soon_.start();
  });
}

SystemDocument::~SystemDocument() { thread_.waitForDone(); }

QString SystemDocument::title() const {
  if (!isOpen()) return {};
  if (modified_ == 0) return FileName(path_);
  return QStringLiteral("%1, modified since %2").arg(FileName(path_), ClockText(modified_).left(5));
}

void SystemDocument::hear() {
  snapshots_.add(WallClock(), WholeSystem(store_.catalogue()));
  if (isOpen()) compare();
}

void SystemDocument::compare() {
  comparison_ = CompareSystems(file_, SystemOf(store_.catalogue(), file_.name).file,
                               Threads::kUnknownInSecond);
  if (comparison_.differences.empty()) {
    modified_ = 0;
  } else if (modified_ == 0) {
    modified_ = WallClock();
  }
  Q_EMIT changed();
}

void SystemDocument::take(const QString& path, SystemFile file) {
  path_ = path;
  file_ = std::move(file);
  modified_ = 0;
  compare();
}

void SystemDocument::open(const QString& path) {
  thread_.start([this, path] {
    auto read = ReadSystemFile(path.toStdString());
    QMetaObject::invokeMethod(this, [this, path, read = std::move(read)] {
      if (!read) return Q_EMIT told(ToQString(read.error().message));
      take(path, *read);
      Q_EMIT opened();
    });
  });
}

void SystemDocument::save(const QString& path) {
  const std::string name = FileName(path).section('.', 0, 0).toStdString();
  thread_.start([this, path, running = SystemOf(store_.catalogue(), name)] {
    const std::string file = path.toStdString();
    const auto system = SystemToSave(file, running);
    const auto written = system ? WriteSystemFile(file, *system) : Result<void>(system.error());
    const QString left_out = running.loose.empty() ? QString() : ToQString(running.LeftOut()[0]);
    QMetaObject::invokeMethod(this, [this, path, system, written, left_out] {
      if (!written) return Q_EMIT told(ToQString(written.error().message));
      take(path, *system);
      const QString saved = QStringLiteral("Saved to ") + FileName(path);
      Q_EMIT told(left_out.isEmpty() ? saved : saved + QStringLiteral("; ") + left_out);
    });
  });
}

void SystemDocument::update(const std::string& what) {
  const SystemFile running = SystemOf(store_.catalogue(), file_.name).file;
  thread_.start([this, path = path_, system = WithPartOf(file_, running, what)] {
    const auto written = WriteSystemFile(path.toStdString(), system);
    QMetaObject::invokeMethod(this, [this, path, system, written] {
      if (!written) return Q_EMIT told(ToQString(written.error().message));
      take(path, system);
      Q_EMIT told(QStringLiteral("Updated ") + FileName(path));
    });
  });
}

}  // namespace tendon::gui
