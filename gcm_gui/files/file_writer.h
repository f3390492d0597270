#pragma once

#include <QByteArray>
#include <QIODevice>
#include <QObject>
#include <QString>
#include <chrono>
#include <functional>
#include <memory>
#include <thread>

namespace tendon::gui {

/// Writes files one after another in its own thread, so that a slow disk does not block the GUI
/// thread. A file is replaced as a whole or not at all.
///
/// Call all functions in the GUI thread; handlers are called in the GUI thread, too.
class FileWriter : public QObject {
  Q_OBJECT

 public:
  /// Writes the content to `file`; called in the writer's thread. Returns false on failure.
  using Fill = std::function<bool(QIODevice& file)>;
  /// Called with an empty text on success; otherwise with the reason, to be appended to the name of
  /// the file.
  using Done = std::function<void(const QString& refusal)>;
  /// Who may read the file.
  enum class Readers { kAll, kOwner };

  static constexpr std::chrono::seconds kTimeout{5};

  /// Returns the writer of the present QCoreApplication, which owns the writer.
  static FileWriter& instance();
  /// Returns a second writer for content that takes long to produce, such as a table or a picture.
  /// Small files, and the state that is saved when the program ends, do not wait for such content.
  static FileWriter& exports();

  /// `timeout` is the maximum time that the destructor waits.
  explicit FileWriter(QObject* parent = nullptr, std::chrono::milliseconds timeout = kTimeout);
  /// Waits at most `timeout` for the remaining files. Then reports on stderr the files that were
  /// not written, and the failures whose handlers could not be called any more.
  ~FileWriter() override;

  /// Requests to write a file. If an earlier request for the same file has not begun, the new
  /// request replaces it. `done` is not called after `context` is destroyed. If `context` or `done`
  /// is null, a failure is not reported.
  void write(const QString& file, Fill fill, const QObject* context, Done done,
             Readers readers = Readers::kAll);
  void write(const QString& file, const QByteArray& content, const QObject* context, Done done,
             Readers readers = Readers::kAll);

  /// Waits until all files are written; returns false on a time-out. Handlers of written files may
  /// be called later.
  bool waitForWritten(std::chrono::milliseconds timeout = kTimeout);

 private:
  struct Job;
  struct FinishedJob;
  struct Queue;

  /// The main function of the thread: writes files until the queue is closed and empty. The thread
  /// may outlive the writer if a disk does not respond.
  static void work(const std::shared_ptr<Queue>& queue);
  /// Calls the handler of the oldest finished request.
  void callNextHandler();

  const std::chrono::milliseconds timeout_;
  std::shared_ptr<Queue> queue_;
  std::thread thread_;
};

/// Returns the sentence for the user: "FILE was not saved: REFUSAL".
[[nodiscard]] QString NotSaved(const QString& file, const QString& refusal);

}  // namespace tendon::gui
