#pragma once

#include <gcm_gui/files/background.h>
#include <gcm_gui/files/gui_poster.h>
#include <gcm_gui/session/column_feed.h>
#include <gcm_gui/session/system_reports.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/recording/playback.h>

#include <QObject>
#include <QString>
#include <QStringList>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tendon::gui {

/// What a file says about itself as a whole. Times are in ns since 1970.
struct RecordingFacts {
  QString file;  ///< its path
  std::int64_t first = 0;
  std::int64_t last = 0;
  QStringList problems;                        ///< sentences about what is damaged or missing
  bool has_no_end = false;                     ///< cut off, or still being written
  bool is_growing = false;                     ///< another program still writes it
  std::vector<Schema> types;                   ///< of all columns and events
  std::map<std::string, Schema> columns = {};  ///< by path, with the type of the latest run
  std::vector<recording::PlayedSpan> events;
  std::vector<recording::PlayedSpan> losses;
};

/// What happened up to a moment of the recording, apart from the rows.
struct ReplayStep {
  std::int64_t position = 0;  ///< ns since 1970
  bool is_jump = false;       ///< what happened before is out of date
  /// The whole catalogue, if it is not the former one with `changes`.
  std::optional<Catalogue> catalogue;
  std::vector<CatalogueChange> changes;
  LogBatch log;
  std::vector<EventRecord> events;
  QStringList problems;  ///< all that are known by now
  bool is_gone = false;  ///< the file is no longer at its place
};

/// A column whose rows are wanted.
struct WantedColumn {
  std::shared_ptr<ColumnFeed> feed;
  bool with_past = false;  ///< otherwise it begins with its newest row
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

/// Reads a recording in a thread of its own. Each function returns at once; a signal answers it, in
/// order. The rows of columns go to their feeds before step() is emitted. GUI thread.
class ReplayReader : public QObject {
  Q_OBJECT

 public:
  /// How much is in the lists of events and log records after a jump.
  static constexpr std::size_t kListed = 1000;

  /// What is read: all, or only the rows of columns and their losses.
  enum class Content { kAll, kRows };

  explicit ReplayReader(Content content = Content::kAll, QObject* parent = nullptr);
  ~ReplayReader() override;

  /// Answered by opened() or refused(). Nothing else works before opened(), or after refused(),
  /// which also answers a function that runs out of memory.
  void open(const QString& file);
  /// Moves to this moment, with everything up to it: rows since `span` before it. The columns
  /// replace all former ones. Answered by stepped().
  void jump(std::int64_t time, std::int64_t span, WantedColumns columns);
  /// Goes on to a later moment. Answered by stepped().
  void play(std::int64_t time);
  /// Adds a column, which begins with its newest row. Answered by stepped().
  void add(const std::string& path, std::shared_ptr<ColumnFeed> feed);
  /// Answered by found().
  void find(ReplayTarget target);

  /// The time of samples at a moment of the recording.
  [[nodiscard]] static std::int64_t SampleTime(std::int64_t time, std::int64_t first);

 Q_SIGNALS:
  void opened(const tendon::gui::RecordingFacts& facts);
  void refused(const QString& sentence);
  void stepped(const tendon::gui::ReplayStep& step);
  /// The moment of the target; empty if there is none.
  void found(std::optional<std::int64_t> time);

 private:
  class Reel;

  /// Runs a task in the thread. If it throws, refused() is the answer.
  void start(std::function<void(Reel&)> task);

  std::shared_ptr<GuiPoster> poster_;
  std::shared_ptr<Reel> reel_;  // used by the thread alone
  Background thread_{QT_TRANSLATE_NOOP("Words", "the reading of a recording"),
                     std::chrono::seconds(2)};
};

}  // namespace tendon::gui
