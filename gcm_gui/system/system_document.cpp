#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/system/system_document.h>
#include <gcm_gui/system/system_parts.h>
#include <tendon/gcm/system/reference_file.h>
#include <tendon/gcm/system/running_system.h>
#include <tendon/gcm/system/system_index.h>

#include <QFile>
#include <QFileInfo>
#include <chrono>
#include <utility>

namespace tendon::gui {
namespace {

constexpr std::chrono::milliseconds kSoon{200};  // many changes come as one

using Layout = std::map<std::string, SystemFile::Position>;

/// That of the components which the file has.
Layout LayoutFor(const SystemFile& file, Layout layout) {
  const SystemIndex index(file);
  std::erase_if(layout, [&](const auto& one) {
    const std::size_t slash = one.first.find('/');
    return index.FindComponent(one.first.substr(0, slash), one.first.substr(slash + 1)) == nullptr;
  });
  return layout;
}

/// What is to be written, or why it is not.
Result<SystemFile> SystemToSave(const std::string& path, RunningSystem running,
                                const std::optional<Layout>& layout) {
  const auto former = ReadSystemFile(path);
  if (former) {
    running.file.name = former->name;
    (void)KeepFrom(*former, running);
  } else if (former.error().code != ErrorCode::kNotFound) {
    return former.error();
  }
  if (layout) running.file.layout = LayoutFor(running.file, *layout);
  return std::move(running.file);
}

Result<ImportedSystem> Import(const QString& path, const std::string& process) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) {
    return Error{ErrorCode::kNotFound, path.toStdString() +
                                           Words::tr(" cannot be read: ").toStdString() +
                                           file.errorString().toStdString()};
  }
  return ParseComponentManagerFile(file.readAll().toStdString(), path.toStdString(), process);
}

QString FileName(const QString& path) { return QFileInfo(path).fileName(); }

}  // namespace

SystemDocument::SystemDocument(const CatalogueStore& store, QObject* parent)
    : QObject(parent), store_(store), courier_(std::make_shared<Courier>(this)) {
  soon_.setSingleShot(true);
  soon_.setInterval(kSoon);
  connect(&soon_, &QTimer::timeout, this, &SystemDocument::hear);
  connect(&store, &CatalogueStore::changed, this, [this] {
    if (!soon_.isActive()) soon_.start();
  });
}

SystemDocument::~SystemDocument() { courier_->detach(); }

QString SystemDocument::title() const {
  if (!isOpen()) return {};
  if (modified_ == 0) return FileName(path_);
  return Words::tr("%1, modified since %2").arg(FileName(path_), ClockText(modified_).left(5));
}

void SystemDocument::hear() {
  snapshots_.add(WallClock(), WholeSystem(store_.catalogue()));
  if (isOpen()) compare();
}

void SystemDocument::compare() {
  is_behind_ = std::exchange(is_comparing_, true);
  if (is_behind_) return;
  comparing_.start([this, courier = courier_, version = version_, file = file_,
                    running = SystemOf(store_.catalogue(), file_.name).file] {
    auto comparison = CompareSystems(file, running, Starts::kUnknownInSecond);
    courier->post([this, version, comparison = std::move(comparison)] {
      is_comparing_ = false;
      const bool is_old = version != version_;
      if (!is_old) show(comparison);
      if (is_old || is_behind_) compare();
    });
  });
}

void SystemDocument::show(SystemComparison comparison) {
  comparison_ = std::move(comparison);
  if (comparison_.differences.empty()) {
    modified_ = 0;
  } else if (modified_ == 0) {
    modified_ = WallClock();
  }
  Q_EMIT changed();
}

void SystemDocument::take(const QString& path, const SystemFile& file, std::function<void()> done) {
  comparing_.start([this, courier = courier_, path, file, done = std::move(done),
                    revision = store_.catalogue().revision(),
                    running = SystemOf(store_.catalogue(), file.name).file] {
    auto comparison = CompareSystems(file, running, Starts::kUnknownInSecond);
    courier->post([this, path, file, done, revision, comparison = std::move(comparison)] {
      path_ = path;
      file_ = file;
      modified_ = 0;
      ++version_;
      show(comparison);
      done();
      if (store_.catalogue().revision() != revision) compare();
    });
  });
}

void SystemDocument::setLayout(Layout layout) { layout_ = std::move(layout); }

void SystemDocument::open(const QString& path) {
  read(path, [this, path](const Result<SystemFile>& read) {
    if (!read) return Q_EMIT told(ToQString(read.error().message));
    take(path, *read, [this] { Q_EMIT opened(); });
  });
}

void SystemDocument::importFrom(const QString& path, const QString& process) {
  thread_.start([this, courier = courier_, path, process = process.toStdString()] {
    const auto imported = Import(path, process);
    courier->post([this, path, imported] {
      if (!imported) return Q_EMIT told(ToQString(imported.error().message));
      const QFileInfo from(path);
      const QString to = from.path() + '/' + from.completeBaseName() + QStringLiteral(".gcm.json");
      take(to, imported->file, [this, to, left_out = imported->left_out] {
        Q_EMIT opened();
        const QString came = Words::tr("Imported; to be saved as ") + FileName(to);
        Q_EMIT told(left_out.empty() ? came
                                     : came + QStringLiteral("; ") + ToQString(left_out.front()));
      });
    });
  });
}

void SystemDocument::read(const QString& path,
                          std::function<void(const Result<SystemFile>&)> done) {
  thread_.start([courier = courier_, path, done = std::move(done)] {
    auto read = ReadSystemFile(path.toStdString());
    courier->post([done, read = std::move(read)] { done(read); });
  });
}

void SystemDocument::save(const QString& path) {
  const std::string name = FileName(path).section('.', 0, 0).toStdString();
  thread_.start([this, courier = courier_, path, running = SystemOf(store_.catalogue(), name),
                 layout = layout_] {
    const std::string file = path.toStdString();
    const auto system = SystemToSave(file, running, layout);
    const auto written = system ? WriteSystemFile(file, *system) : Result<void>(system.error());
    const QString left_out = running.loose.empty() ? QString() : ToQString(running.LeftOut()[0]);
    courier->post([this, path, system, written, left_out] {
      if (!written) return Q_EMIT told(ToQString(written.error().message));
      const QString saved = Words::tr("Saved to ") + FileName(path);
      take(path, *system, [this, saved, left_out] {
        Q_EMIT told(left_out.isEmpty() ? saved : saved + QStringLiteral("; ") + left_out);
      });
    });
  });
}

void SystemDocument::update(const std::string& what) {
  const SystemFile running = SystemOf(store_.catalogue(), file_.name).file;
  thread_.start(
      [this, courier = courier_, path = path_, system = WithPartOf(file_, running, what)] {
        const auto written = WriteSystemFile(path.toStdString(), system);
        courier->post([this, path, system, written] {
          if (!written) return Q_EMIT told(ToQString(written.error().message));
          take(path, system, [this, path] { Q_EMIT told(Words::tr("Updated ") + FileName(path)); });
        });
      });
}

}  // namespace tendon::gui
