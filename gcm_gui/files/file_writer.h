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

/// Writes files one after another in its own thread, so a slow disk blocks nobody. A file is
/// replaced as a whole or not at all.
///
/// Call all functions in the GUI thread; handlers run there, too.
class FileWriter : public QObject {
  Q_OBJECT

 public:
  /// Writes the content, in the writer's thread; returns false on failure.
  using Fill = std::function<bool(QIODevice& file)>;
  /// Receives an empty text on success; otherwise the reason, to be appended to the file's name.
  using Done = std::function<void(const QString& refusal)>;
  /// Who may read the file.
  enum class Readers { kAll, kOwner };

  static constexpr std::chrono::seconds kPatience{5};

  /// The writer of the present QCoreApplication, which owns it.
  static FileWriter& instance();
  /// A second writer for content that takes long to make: a table, a picture. It does not delay
  /// small files, nor the state saved at the end.
  static FileWriter& exports();

  /// `patience` is how long the destructor waits.
  explicit FileWriter(QObject* parent = nullptr, std::chrono::milliseconds patience = kPatience);
  /// Waits at most `patience` for the remaining files. Then reports on stderr the files that were
  /// not written, and the failures whose handlers could not be called any more.
  ~FileWriter() override;

  /// A second request for a file replaces the first one if that has not begun. `done` is not called
  /// after `context` is destroyed. If either is null, a failure is not reported.
  void write(const QString& file, Fill fill, const QObject* context, Done done,
             Readers readers = Readers::kAll);
  void write(const QString& file, const QByteArray& content, const QObject* context, Done done,
             Readers readers = Readers::kAll);

  /// Returns false on a time-out. Handlers of written files may still follow.
  bool waitForWritten(std::chrono::milliseconds patience = kPatience);

 private:
  struct Job;
  struct Answer;
  struct Queue;

  /// Runs until the queue is closed and empty. Outlives the writer if a disk does not answer.
  static void work(const std::shared_ptr<Queue>& queue);
  /// Calls the handler of the oldest answer.
  void callNextHandler();

  const std::chrono::milliseconds patience_;
  std::shared_ptr<Queue> queue_;
  std::thread thread_;
};

/// The sentence for the user: "FILE was not saved: REFUSAL".
[[nodiscard]] QString NotSaved(const QString& file, const QString& refusal);

}  // namespace tendon::gui
