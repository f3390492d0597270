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

/// Writes files in a thread of its own, one after the other: a slow disk, which every safely
/// written file waits for, holds up nobody. A file is there whole, or as it was before.
///
/// All functions are of the GUI thread; so is what they call.
class FileWriter : public QObject {
  Q_OBJECT

 public:
  /// What is written into the file, in the thread of the writer: false where it cannot be.
  using Fill = std::function<bool(QIODevice& file)>;
  /// Empty where the file is written; else why not, in words that begin after the file's name.
  using Done = std::function<void(const QString& refusal)>;
  /// Who may read the file.
  enum class Readers { kAll, kOwner };

  static constexpr std::chrono::seconds kPatience{5};

  /// The one of this QCoreApplication, which it belongs to.
  static FileWriter& instance();
  /// Another one, for what takes long to be made: a table, a picture. It holds up none of the small
  /// files, nor what is remembered at the end.
  static FileWriter& exports();

  /// `patience`: of the destructor.
  explicit FileWriter(QObject* parent = nullptr, std::chrono::milliseconds patience = kPatience);
  /// Waits for what is still to be written, as long as its patience lasts; then it says on stderr
  /// what was not, and what was refused and could be told to nobody any more.
  ~FileWriter() override;

  /// One that is asked for again before it was begun is written once, as it was asked for last.
  /// `done` is not called once `context` is gone; without either nobody hears of it.
  void write(const QString& file, Fill fill, const QObject* context, Done done,
             Readers readers = Readers::kAll);
  void write(const QString& file, const QByteArray& content, const QObject* context, Done done,
             Readers readers = Readers::kAll);

  /// False where it took longer. The handlers of what was written may still be to come.
  bool waitForWritten(std::chrono::milliseconds patience = kPatience);

 private:
  struct Job;
  struct Answer;
  struct Queue;

  /// Until the queue is closed and empty. Outlives the writer where a disk does not answer.
  static void work(const std::shared_ptr<Queue>& queue);
  /// The oldest answer, to who waits for it.
  void tell();

  const std::chrono::milliseconds patience_;
  std::shared_ptr<Queue> queue_;
  std::thread thread_;
};

/// The sentence for the user: "FILE was not saved: REFUSAL".
[[nodiscard]] QString NotSaved(const QString& file, const QString& refusal);

}  // namespace tendon::gui
