#include <gcm_gui/files/file_writer.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>

#include <QCoreApplication>
#include <QPointer>
#include <QSaveFile>
#include <algorithm>
#include <condition_variable>
#include <deque>
#include <iostream>
#include <mutex>
#include <utility>
#include <vector>

namespace tendon::gui {
namespace {

struct Listener {
  QPointer<const QObject> context;  // used in the GUI thread only
  FileWriter::Done done;
};

FileWriter& OfApplication(QPointer<FileWriter>& writer) {
  if (writer == nullptr) writer = new FileWriter(QCoreApplication::instance());
  return *writer;
}

QString Write(const QString& name, const FileWriter::Fill& fill, FileWriter::Readers readers) try {
  QSaveFile file(name);
  if (!file.open(QIODevice::WriteOnly)) return file.errorString();
  if (readers == FileWriter::Readers::kOwner) {
    file.setPermissions(QFileDevice::ReadOwner | QFileDevice::WriteOwner);
  }
  if (!fill(file)) {
    file.cancelWriting();
    return file.error() == QFileDevice::NoError ? Words::tr("the content cannot be encoded")
                                                : file.errorString();
  }
  return file.commit() ? QString() : file.errorString();
} catch (...) {
  return CurrentExceptionText();
}

}  // namespace

struct FileWriter::Job {
  QString file;
  Fill fill;
  Readers readers = Readers::kAll;
  std::vector<Listener> listeners;
};

struct FileWriter::FinishedJob {
  QString file;
  QString refusal;
  std::vector<Listener> listeners;
};

struct FileWriter::Queue {
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Job> jobs;              // guarded by mutex, as are all members below
  std::deque<FinishedJob> finished;  // jobs whose listeners were not called yet
  QString current;                   // the file being written
  bool is_closed = false;            // no more jobs will be added
  bool is_done = false;              // the thread has ended
  FileWriter* writer = nullptr;      // receives the finished jobs; null after it was destroyed
};

QString NotSaved(const QString& file, const QString& refusal) {
  return Words::tr("%1 was not saved: %2").arg(file, refusal);
}

FileWriter& FileWriter::instance() {
  static QPointer<FileWriter> writer;
  return OfApplication(writer);
}

FileWriter& FileWriter::exports() {
  static QPointer<FileWriter> writer;
  return OfApplication(writer);
}

FileWriter::FileWriter(QObject* parent, std::chrono::milliseconds timeout)
    : QObject(parent), timeout_(timeout), queue_(std::make_shared<Queue>()) {
  queue_->writer = this;
  thread_ = std::thread([queue = queue_] { work(queue); });
}

FileWriter::~FileWriter() {
  std::unique_lock lock(queue_->mutex);
  queue_->writer = nullptr;
  queue_->is_closed = true;
  queue_->changed.notify_all();
  const bool is_done = queue_->changed.wait_for(lock, timeout_, [this] { return queue_->is_done; });
  for (const FinishedJob& job : queue_->finished) {
    if (job.refusal.isEmpty()) continue;
    std::cerr << "gcm-gui: " << NotSaved(job.file, job.refusal).toStdString() << '\n';
  }
  queue_->finished.clear();
  if (is_done) {
    lock.unlock();
    thread_.join();
    return;
  }
  if (!queue_->current.isEmpty()) {
    std::cerr << "gcm-gui: " << queue_->current.toStdString() << " was not written: it took longer "
              << "than " << timeout_.count() << " ms\n";
  }
  for (const Job& job : queue_->jobs) {
    std::cerr << "gcm-gui: " << job.file.toStdString() << " was not written\n";
  }
  queue_->jobs.clear();
  thread_.detach();
}

void FileWriter::write(const QString& file, Fill fill, const QObject* context, Done done,
                       Readers readers) {
  const std::lock_guard lock(queue_->mutex);
  auto& jobs = queue_->jobs;
  auto job = std::find_if(jobs.begin(), jobs.end(),
                          [&](const Job& waiting) { return waiting.file == file; });
  if (job == jobs.end()) {
    jobs.push_back({.file = file, .fill = {}, .readers = readers, .listeners = {}});
    job = jobs.end() - 1;
  }
  job->fill = std::move(fill);
  job->readers = readers;
  if (done) job->listeners.push_back({context, std::move(done)});
  queue_->changed.notify_all();
}

void FileWriter::write(const QString& file, const QByteArray& content, const QObject* context,
                       Done done, Readers readers) {
  write(
      file, [content](QIODevice& device) { return device.write(content) == content.size(); },
      context, std::move(done), readers);
}

bool FileWriter::waitForWritten(std::chrono::milliseconds timeout) {
  std::unique_lock lock(queue_->mutex);
  return queue_->changed.wait_for(
      lock, timeout, [this] { return queue_->jobs.empty() && queue_->current.isEmpty(); });
}

void FileWriter::callNextHandler() {
  std::unique_lock lock(queue_->mutex);
  const FinishedJob job = std::move(queue_->finished.front());
  queue_->finished.pop_front();
  lock.unlock();
  for (const Listener& listener : job.listeners) {
    if (listener.context != nullptr) listener.done(job.refusal);
  }
}

void FileWriter::work(const std::shared_ptr<Queue>& queue) {
  std::unique_lock lock(queue->mutex);
  while (true) {
    queue->changed.wait(lock, [&] { return queue->is_closed || !queue->jobs.empty(); });
    if (queue->jobs.empty()) break;
    Job job = std::move(queue->jobs.front());
    queue->jobs.pop_front();
    queue->current = job.file;
    lock.unlock();
    const QString refusal = Write(job.file, job.fill, job.readers);
    job.fill = {};
    lock.lock();
    queue->current.clear();
    queue->changed.notify_all();
    if (job.listeners.empty()) continue;
    queue->finished.push_back({job.file, refusal, std::move(job.listeners)});
    if (queue->writer == nullptr) continue;
    QMetaObject::invokeMethod(queue->writer, &FileWriter::callNextHandler, Qt::QueuedConnection);
  }
  queue->is_done = true;
  queue->changed.notify_all();
}

}  // namespace tendon::gui
