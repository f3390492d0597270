#pragma once

#include <gcm_gui/files/background.h>
#include <gcm_gui/files/gui_poster.h>
#include <gcm_gui/session/column_feed.h>
#include <gcm_gui/session/system_reports.h>
#include <tendon/base/os/random_access_file.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/recording/playback.h>

#include <QObject>
#include <QString>
#include <QStringList>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tendon::gui {

/// The properties of a whole recording. Times are in ns since 1970.
struct RecordingFacts {
  QString file;  ///< its path, without symbolic links
  std::int64_t first = 0;
  std::int64_t last = 0;
  QStringList problems;                        ///< sentences about damaged or missing parts
  bool has_no_end = false;                     ///< cut off, or still being written
  bool is_growing = false;                     ///< another program still writes it
  std::vector<Schema> types;                   ///< of all columns and events
  std::map<std::string, Schema> columns = {};  ///< by path, with the type of the latest run
  std::vector<recording::PlayedSpan> events;
  std::vector<recording::PlayedSpan> losses;
};

/// The changes up to a moment of the recording, except the rows.
struct ReplayStep {
  std::int64_t position = 0;  ///< ns since 1970
  bool is_jump = false;       ///< all earlier steps are outdated
  /// The whole catalogue; empty if the catalogue is the previous one with `changes`.
  std::optional<Catalogue> catalogue;
  std::vector<CatalogueChange> changes;
  LogBatch log;
  std::vector<EventRecord> events;
  QStringList problems;  ///< all that are known by now
  bool is_gone = false;  ///< the file no longer exists at its path
};

/// A column whose rows are wanted.
struct WantedColumn {
  std::shared_ptr<ColumnFeed> feed;
  bool with_past = false;  ///< if false, it begins with its newest row
};
using WantedColumns = std::map<std::string, WantedColumn>;  ///< by path

enum class ReplayTarget {
  kNextRow,
  kPreviousRow,
  kNextEvent,
  kPreviousEvent,
  kNextLoss,
  kPreviousLoss
};

/// Reads a recording in its own thread. Each function returns at once. Its result arrives as a
/// signal; the signals are in the order of the calls. The rows of columns are passed to their feeds
/// before stepped() is emitted. GUI thread.
///
/// The destructor cancels the reading and does not wait for it, however slow the disk is. The
/// thread ends after its present read from the disk; the results are dropped.
class ReplayReader : public QObject {
  Q_OBJECT

 public:
  /// The number of entries in the lists of events and of log records after a jump.
  static constexpr std::size_t kListed = 1000;

  /// The content to read: everything, or only the rows of columns and their losses.
  enum class Content { kAll, kRows };
  /// Opens a file; called in the thread. Tests use it to simulate a slow disk.
  using OpenFile = std::function<Result<std::unique_ptr<os::RandomAccessFile>>(
      const std::filesystem::path& file)>;

  explicit ReplayReader(Content content = Content::kAll,
                        OpenFile open_file = os::OpenRandomAccessFile);
  ~ReplayReader() override;

  /// The result is opened() or refused(). Other functions must not be called before opened() or
  /// after refused(). If memory is exhausted in any function, its result is refused(), too.
  void open(const QString& file);
  /// Moves to this moment, and delivers the data before it, with the rows of the last `span`.
  /// `columns` replace all former columns. The result is stepped().
  void jump(std::int64_t time, std::int64_t span, WantedColumns columns);
  /// Continues to a later moment. The result is stepped().
  void play(std::int64_t time);
  /// Adds a column, which begins with its newest row. The result is stepped().
  void add(const std::string& path, std::shared_ptr<ColumnFeed> feed);
  /// Answered by found().
  void find(ReplayTarget target);

  /// Converts a moment of the recording to the time of samples.
  [[nodiscard]] static std::int64_t SampleTime(std::int64_t time, std::int64_t first);

 Q_SIGNALS:
  void opened(const tendon::gui::RecordingFacts& facts);
  void refused(const QString& sentence);
  void stepped(const tendon::gui::ReplayStep& step);
  /// The moment of the target; empty if there is none.
  void found(std::optional<std::int64_t> time);

 private:
  class Reel;

  /// Runs a task in the thread. If the task throws, the result is refused().
  void start(std::function<void(Reel&)> task);

  std::shared_ptr<GuiPoster> poster_;
  std::shared_ptr<Reel> reel_;  // used by the thread alone, except cancel()
  Background thread_{QT_TRANSLATE_NOOP("Words", "the reading of a recording")};
};

}  // namespace tendon::gui
