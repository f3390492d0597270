#include <gcm_gui/system/system_document.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/system/system_parts.h>
#include <tendon/gcm/system/component_manager_file.h>
#include <tendon/gcm/system/running_system.h>
#include <tendon/gcm/system/system_index.h>

#include <QFile>
#include <QFileInfo>
#include <QPointer>
#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

namespace tendon::gui {
namespace {

// Several changes within this time are handled together.
constexpr std::chrono::milliseconds kSoon{200};

using Layout = std::map<std::string, SystemFile::Position>;

/// Returns the positions of the components that are in the file.
Layout LayoutFor(const SystemFile& file, Layout layout) {
  const SystemIndex index(file);
  std::erase_if(layout, [&](const auto& one) {
    const std::size_t slash = one.first.find('/');
    return index.FindComponent(one.first.substr(0, slash), one.first.substr(slash + 1)) == nullptr;
  });
  return layout;
}

/// Keeps those components and connections of the file that do not exist yet, but whose process
/// exists now.
void KeepMissing(const SystemFile& former, RunningSystem& running) {
  const SystemIndex now(running.file);
  std::vector<SystemFile::Connection> connections;
  for (const auto& connection : former.connections) {
    const std::string& process = connection.required.process;
    if (now.FindProcess(process) == nullptr) continue;
    if (now.FindConnection(connection.required) == nullptr) connections.push_back(connection);
  }
  std::vector<std::pair<std::string, SystemFile::Component>> components;
  for (const auto& process : former.processes) {
    if (now.FindProcess(process.name) == nullptr) continue;
    for (const auto& component : process.components) {
      const bool runs = now.FindComponent(process.name, component.name) != nullptr;
      if (!runs) components.emplace_back(process.name, component);
    }
  }
  for (const auto& [process, component] : components) {
    std::ranges::find(running.file.processes, process, &SystemFile::Process::name)
        ->components.push_back(component);
  }
  running.loose.insert(running.loose.end(), connections.begin(), connections.end());
}

enum class MissingParts { kLeftOut, kKept };

/// Returns the content to save, or the reason why it cannot be saved.
Result<SystemFile> SystemToSave(const std::string& path, RunningSystem running,
                                const message::Children& children,
                                const std::optional<Layout>& layout, MissingParts missing) {
  const auto former = ReadSystemFile(path);
  if (former) {
    running.file.name = former->name;
    if (missing == MissingParts::kKept) KeepMissing(*former, running);
    (void)KeepFrom(*former, running);
  } else if (former.error().code != ErrorCode::kNotFound) {
    return former.error();
  }
  SetStarts(children, running.file);
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

std::string SystemName(const QString& path) {
  return FileName(path).section('.', 0, 0).toStdString();
}

/// Imports a file and writes it as a system file. Never overwrites a file, because its content
/// would be lost.
Result<ImportedSystem> ImportTo(const QString& to, const QString& from,
                                const std::string& process) {
  auto imported = Import(from, process);
  if (!imported) return imported;
  if (QFileInfo::exists(to)) {
    return Error{ErrorCode::kExists,
                 Words::tr("%1 already exists: open it, or remove it before the import")
                     .arg(FileName(to))
                     .toStdString()};
  }
  imported->file.name = SystemName(to);
  const auto written = WriteSystemFile(to.toStdString(), imported->file);
  return written ? imported : Result<ImportedSystem>(written.error());
}

}  // namespace

SystemDocument::SystemDocument(const CatalogueStore& store, SystemReports& reports, QObject* parent)
    : QObject(parent),
      store_(store),
      reports_(reports),
      poster_(std::make_shared<GuiPoster>(this)) {
  soon_.setSingleShot(true);
  soon_.setInterval(kSoon);
  connect(&soon_, &QTimer::timeout, this, Guarded(this, &SystemDocument::onCatalogueChanged));
  connect(&store, &CatalogueStore::changed, this, [this] {
    if (!soon_.isActive()) soon_.start();
  });
}

SystemDocument::~SystemDocument() {
  for (const QString& path : std::as_const(unsaved_)) write(path, {});
  poster_->detach();
}

QString SystemDocument::title() const {
  if (!isOpen()) return {};
  if (modified_ == 0) return FileName(path_);
  return Words::tr("%1, modified since %2").arg(FileName(path_), ClockText(modified_).left(5));
}

void SystemDocument::onCatalogueChanged() {
  snapshots_.add(WallClock(), WholeSystem(store_.catalogue()));
  if (isOpen()) compare();
}

void SystemDocument::compare() {
  is_behind_ = std::exchange(is_comparing_, true);
  if (is_behind_) return;
  comparing_.start([this, poster = poster_, version = version_, file = file_,
                    running = SystemOf(store_.catalogue(), file_.name).file] {
    SystemComparison comparison;
    const bool is_done = ExceptionGuard::run(
        QT_TRANSLATE_NOOP("Words", "the comparison with a system file"),
        [&] { comparison = CompareSystems(file, running, StartComparison::kIgnore); });
    poster->post([this, version, is_done, comparison = std::move(comparison)] {
      is_comparing_ = false;
      const bool is_old = version != version_;
      if (!is_old && is_done) show(comparison);
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
  comparing_.start([this, poster = poster_, path, file, done = std::move(done),
                    revision = store_.catalogue().revision(),
                    running = SystemOf(store_.catalogue(), file.name).file] {
    auto comparison = CompareSystems(file, running, StartComparison::kIgnore);
    poster->post([this, path, file, done, revision, comparison = std::move(comparison)] {
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
    if (!read) return Q_EMIT notice(ToQString(read.error().message));
    imported_.clear();
    take(path, *read, [this] { Q_EMIT opened(); });
  });
}

void SystemDocument::importFrom(const QString& path, const QString& process) {
  const QFileInfo from(path);
  const QString to = from.path() + '/' + from.completeBaseName() + QStringLiteral(".gcm.json");
  thread_.start([this, poster = poster_, path, to, process = process.toStdString()] {
    const auto imported = ImportTo(to, path, process);
    poster->post([this, to, imported] {
      if (!imported) return Q_EMIT notice(ToQString(imported.error().message));
      imported_ = to;
      take(to, imported->file, [this, to, left_out = imported->left_out] {
        Q_EMIT opened();
        const QString came = Words::tr("Imported to ") + FileName(to);
        Q_EMIT notice(left_out.empty() ? came
                                       : came + QStringLiteral("; ") + ToQString(left_out.front()));
      });
    });
  });
}

void SystemDocument::read(const QString& path,
                          std::function<void(const Result<SystemFile>&)> done) {
  thread_.start([poster = poster_, path, done = std::move(done)] {
    auto read = ReadSystemFile(path.toStdString());
    poster->post([done, read = std::move(read)] { done(read); });
  });
}

std::optional<SystemDocument::StartedProcesses> SystemDocument::startedBy(
    const Result<message::Children>& reply) {
  if (reply) return StartedProcesses{*reply, {}};
  if (reply.error().code == ErrorCode::kDenied) {
    return StartedProcesses{
        {}, Words::tr("this GCM is too old to report which processes it has started")};
  }
  Q_EMIT notice(ToQString(reply.error().message));
  return std::nullopt;
}

void SystemDocument::save(const QString& path) {
  unsaved_.append(path);
  reports_.askChildren([self = QPointer(this), path](const Result<message::Children>& reply) {
    if (self == nullptr) return;
    self->unsaved_.removeOne(path);
    if (const auto started = self->startedBy(reply)) self->write(path, *started);
  });
}

void SystemDocument::write(const QString& path, const StartedProcesses& started) {
  RunningSystem running = SystemOf(store_.catalogue(), SystemName(path));
  const MissingParts missing = path == imported_ ? MissingParts::kKept : MissingParts::kLeftOut;
  QStringList sentences{Words::tr("Saved to ") + FileName(path)};
  if (!running.loose.empty()) sentences.append(ToQString(running.LeftOut()[0]));
  if (!started.note.isEmpty()) sentences.append(started.note);
  thread_.start([this, poster = poster_, path, missing, layout = layout_,
                 children = started.children, running = std::move(running), sentences] {
    const std::string file = path.toStdString();
    const auto system = SystemToSave(file, running, children, layout, missing);
    const auto written = system ? WriteSystemFile(file, *system) : Result<void>(system.error());
    poster->post([this, path, system, written, sentences] {
      if (!written) return Q_EMIT notice(ToQString(written.error().message));
      take(path, *system,
           [this, sentences] { Q_EMIT notice(sentences.join(QStringLiteral("; "))); });
    });
  });
}

void SystemDocument::update(const std::string& what) {
  reports_.askChildren(
      [self = QPointer(this), what, path = path_](const Result<message::Children>& reply) {
        if (self == nullptr || self->path_ != path) return;
        if (const auto started = self->startedBy(reply)) self->writePart(what, *started);
      });
}

void SystemDocument::writePart(const std::string& what, const StartedProcesses& started) {
  SystemFile running = SystemOf(store_.catalogue(), file_.name).file;
  SetStarts(started.children, running);
  thread_.start([this, poster = poster_, path = path_, system = WithPartOf(file_, running, what)] {
    const auto written = WriteSystemFile(path.toStdString(), system);
    poster->post([this, path, system, written] {
      if (!written) return Q_EMIT notice(ToQString(written.error().message));
      take(path, system, [this, path] { Q_EMIT notice(Words::tr("Updated ") + FileName(path)); });
    });
  });
}

}  // namespace tendon::gui
