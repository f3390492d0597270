#include <gcm_gui/replay/replay_reader.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <tendon/base/path.h>
#include <tendon/lockfree/flag.h>
#include <tendon/payload/json.h>

#include <QFileInfo>
#include <algorithm>
#include <exception>
#include <utility>

namespace tendon::gui {
namespace {

using recording::Playback;
using recording::PlayedItem;

constexpr std::int64_t kBeforeBegin = 1'000'000'000'000;  // ns; so that no sample is before 0
constexpr std::size_t kMaxRows = 4096;                    // of a batch
constexpr qsizetype kMaxProblems = 20;

LogLevel LevelOf(std::uint8_t ros_level) {
  if (ros_level >= 40) return LogLevel::kError;
  if (ros_level >= 30) return LogLevel::kWarning;
  return ros_level >= 20 ? LogLevel::kInfo : LogLevel::kDebug;
}

message::LogRecord RecordOf(const recording::RosLog& log) {
  const std::size_t slash = log.name.find('/');
  message::LogRecord record;
  record.time = log.stamp.count();
  record.level = LevelOf(log.level);
  record.process = log.name.substr(0, slash);
  record.source = slash == std::string::npos ? record.process : log.name.substr(slash + 1);
  record.text = log.msg;
  return record;
}

EventRecord RecordOf(const recording::PlayedEvent& event, std::int64_t time) {
  EventRecord record{.when = time, .path = ToQString(event.channel->path), .value = {}};
  if (event.channel->schema.is_none()) return record;
  const auto json = ToJson(event.channel->schema, event.value);
  record.value = ToQString(json ? *json : json.error().message);
  return record;
}

/// The path of a column's table: "robot/arm/state".
std::string TableOf(const std::string& column) { return column.substr(0, column.find('.')); }

QStringList SentencesOf(const mcap::Problems& problems) {
  QStringList sentences;
  for (const mcap::Problem& problem : problems.first()) {
    if (sentences.size() == kMaxProblems) break;
    sentences << ToQString(problem.sentence);
  }
  return sentences;
}

/// Collects rows of a column and passes them to its feed.
class RowCollector {
 public:
  RowCollector(WantedColumn wanted, std::int64_t first)
      : wanted_(std::move(wanted)), first_(first) {}

  [[nodiscard]] const WantedColumn& wanted() const { return wanted_; }

  void subscribe(const Schema& schema) {
    wanted_.feed->OnSubscribed({schema});
    subscribed_ = schema;
  }

  void add(const recording::PlayedValue& value, mcap::Timestamp time) {
    if (value.channel != channel_) begin(*value.channel);
    const auto low = static_cast<std::uint32_t>(value.tick);
    // The file has the low 32 bits of each tick. As in MissingRowsBetween(), a slightly smaller
    // tick belongs to an earlier row.
    const std::uint64_t former = last_tick_.value_or(low);
    const auto step = static_cast<std::int32_t>(low - static_cast<std::uint32_t>(former));
    const bool is_before_begin =
        step < 0 && former < static_cast<std::uint64_t>(-std::int64_t{step});
    last_tick_ = is_before_begin ? low : former + static_cast<std::uint64_t>(std::int64_t{step});
    ticks_.push_back(*last_tick_);
    times_.push_back(ReplayReader::SampleTime(static_cast<std::int64_t>(time), first_));
    ends_.push_back(bytes_.size() + value.body.size());
    bytes_.insert(bytes_.end(), value.body.begin(), value.body.end());
    if (ticks_.size() >= kMaxRows) flush();
  }

  void add(const recording::Loss& loss) {
    flush();
    lost_.table += loss.table;
    lost_.network += loss.network;
    lost_.viewer += loss.recorder;
  }

  void flush() {
    if (ticks_.empty() && lost_.all() == 0) return;
    RowBatch batch;
    batch.epoch = channel_ == nullptr ? 0 : channel_->run;
    batch.lost = std::exchange(lost_, {});
    batch.count = ticks_.size();
    batch.ticks = ticks_;
    batch.times = times_;
    batch.cell = [this](std::size_t row, std::size_t) {
      const std::size_t from = row == 0 ? 0 : ends_[row - 1];
      return std::span<const std::byte>(bytes_).subspan(from, ends_[row] - from);
    };
    wanted_.feed->OnRows(batch);
    ticks_.clear();
    times_.clear();
    ends_.clear();
    bytes_.clear();
  }

 private:
  void begin(const recording::PlayedChannel& channel) {
    flush();
    if (subscribed_ != channel.schema) subscribe(channel.schema);
    channel_ = &channel;
    last_tick_.reset();
  }

  WantedColumn wanted_;
  std::int64_t first_;
  std::optional<Schema> subscribed_;  // how the feed reads rows; each run has its own type
  const recording::PlayedChannel* channel_ = nullptr;
  std::optional<std::uint64_t> last_tick_;
  LostRows lost_;
  std::vector<std::uint64_t> ticks_;
  std::vector<std::int64_t> times_;
  std::vector<std::size_t> ends_;  // of each cell, in bytes_
  std::vector<std::byte> bytes_;
};

/// A file from which nothing is read any more after the flag is set.
class CancellableFile final : public os::RandomAccessFile {
 public:
  CancellableFile(std::unique_ptr<os::RandomAccessFile> file, const Flag& is_cancelled)
      : file_(std::move(file)), is_cancelled_(is_cancelled) {}

  [[nodiscard]] const std::string& name() const noexcept override { return file_->name(); }
  [[nodiscard]] std::uint64_t size() const noexcept override { return file_->size(); }
  Result<void> ReadAt(std::uint64_t offset, std::span<std::byte> bytes) override {
    if (is_cancelled_.Get()) return Error{ErrorCode::kFailed, "the reading was cancelled"};
    return file_->ReadAt(offset, bytes);
  }
  [[nodiscard]] bool is_being_written() const noexcept override {
    return file_->is_being_written();
  }

 private:
  const std::unique_ptr<os::RandomAccessFile> file_;
  const Flag& is_cancelled_;
};

}  // namespace

/// The open file. Used only by the thread of the reader, except cancel().
class ReplayReader::Reel {
 public:
  Reel(Content content, OpenFile open_file) : content_(content), open_file_(std::move(open_file)) {}

  /// After this call, the reading ends as soon as possible: nothing more is read from the disk, and
  /// at most the rows that were just read are passed to the feeds. Called by another thread.
  void cancel() { is_cancelled_.Set(true); }

  Result<RecordingFacts> open(const QString& file) {
    auto opened = open_file_(file.toStdString());
    if (!opened) return opened.error();
    auto reader =
        mcap::Reader::Open(std::make_unique<CancellableFile>(*std::move(opened), is_cancelled_));
    if (!reader) return reader.error();
    auto playback = Playback::Open(*std::move(reader));
    if (!playback) return playback.error();
    playback_ = *std::move(playback);
    RecordingFacts facts;
    const QString path = QFileInfo(file).canonicalFilePath();
    facts.file = path.isEmpty() ? file : path;
    facts.first = static_cast<std::int64_t>(playback_->first_time());
    facts.last = static_cast<std::int64_t>(playback_->last_time());
    facts.has_no_end = playback_->reader().was_scanned();
    facts.is_growing = facts.has_no_end && playback_->reader().is_being_written();
    facts.types = playback_->types();
    for (const std::string& column : playback_->columns()) {
      facts.columns.emplace(column, *playback_->FindSchema(column));
    }
    file_ = file;
    facts.events = playback_->Spans(Playback::Kind::kEvents);
    facts.losses = playback_->Spans(Playback::Kind::kLosses);
    facts.problems = SentencesOf(playback_->reader().problems());
    return facts;
  }

  ReplayStep jump(std::int64_t time, std::int64_t span, WantedColumns columns) {
    playback_->Seek(static_cast<mcap::Timestamp>(time));
    ReplayStep step = begin(time);
    step.is_jump = true;
    columns_.clear();
    for (auto& [path, wanted] : columns) addCollector(path, std::move(wanted));
    choose();
    std::vector<std::string> with_past;
    std::vector<std::string> newest;
    for (const auto& [path, collector] : columns_) {
      (collector.wanted().with_past ? with_past : newest).push_back(path);
    }
    const auto handler = [&](const PlayedItem& item) { take(item, step); };
    const std::int64_t first = static_cast<std::int64_t>(playback_->first_time());
    using WithLosses = Playback::WithLosses;
    playback_->Past(with_past, static_cast<mcap::Timestamp>(std::max(first, time - span)),
                    WithLosses::kYes, handler);
    playback_->Past(newest, static_cast<mcap::Timestamp>(time), WithLosses::kNo, handler);
    if (content_ == Content::kAll) {
      step.catalogue = playback_->CatalogueNow();
      playback_->LastEvents(kListed, handler);
      playback_->LastLog(kListed, handler);
      step.log.is_current = true;
    }
    end(step);
    return step;
  }

  ReplayStep play(std::int64_t time) {
    ReplayStep step = begin(time);
    bool has_snapshot = false;
    playback_->PlayUpTo(static_cast<mcap::Timestamp>(time), [&](const PlayedItem& item) {
      const auto* change = std::get_if<recording::PlayedChange>(&item.content);
      has_snapshot = has_snapshot || (change != nullptr && change->begins_snapshot);
      take(item, step);
    });
    if (has_snapshot) step.catalogue = playback_->CatalogueNow();
    end(step);
    return step;
  }

  ReplayStep add(const std::string& path, std::shared_ptr<ColumnFeed> feed) {
    const auto time = static_cast<std::int64_t>(playback_->position());
    ReplayStep step = begin(time);
    addCollector(path, {std::move(feed), false});
    choose();
    playback_->Past({path}, playback_->position(), Playback::WithLosses::kNo,
                    [&](const PlayedItem& item) { take(item, step); });
    end(step);
    return step;
  }

  std::optional<std::int64_t> find(ReplayTarget target) {
    const mcap::Timestamp now = playback_->position();
    std::optional<mcap::Timestamp> time;
    switch (target) {
      case ReplayTarget::kNextRow:
        time = playback_->NextStep();
        break;
      case ReplayTarget::kPreviousRow:
        time = playback_->PreviousStep();
        break;
      case ReplayTarget::kNextEvent:
        time = playback_->FindNext(Playback::Kind::kEvents, now);
        break;
      case ReplayTarget::kPreviousEvent:
        time = playback_->FindPrevious(Playback::Kind::kEvents, now);
        break;
      case ReplayTarget::kNextLoss:
        time = playback_->FindNext(Playback::Kind::kLosses, now);
        break;
      case ReplayTarget::kPreviousLoss:
        time = playback_->FindPrevious(Playback::Kind::kLosses, now);
        break;
    }
    return time ? std::optional(static_cast<std::int64_t>(*time)) : std::nullopt;
  }

 private:
  static ReplayStep begin(std::int64_t time) {
    ReplayStep step;
    step.position = time;
    return step;
  }

  void addCollector(const std::string& path, WantedColumn wanted) {
    RowCollector collector(std::move(wanted), static_cast<std::int64_t>(playback_->first_time()));
    if (const Schema* schema = playback_->FindSchema(path)) {
      collector.subscribe(*schema);
    } else {
      collector.wanted().feed->OnStale(
          {ErrorCode::kNotFound, "the recording does not contain " + path});
    }
    columns_.insert_or_assign(path, std::move(collector));
  }

  void choose() {
    std::vector<std::string> paths;
    for (const auto& [path, collector] : columns_) paths.push_back(path);
    playback_->Choose(paths);
  }

  void take(const PlayedItem& item, ReplayStep& step) {
    if (is_cancelled_.Get()) return;
    if (const auto* value = std::get_if<recording::PlayedValue>(&item.content)) {
      const auto found = columns_.find(value->channel->path);
      if (found != columns_.end()) found->second.add(*value, item.time);
    } else if (const auto* loss = std::get_if<recording::Loss>(&item.content)) {
      for (auto& [path, collector] : columns_) {
        if (TableOf(path) == loss->path) collector.add(*loss);
      }
    } else if (content_ == Content::kRows) {
      return;
    } else if (const auto* event = std::get_if<recording::PlayedEvent>(&item.content)) {
      step.events.push_back(RecordOf(*event, static_cast<std::int64_t>(item.time)));
    } else if (const auto* log = std::get_if<recording::RosLog>(&item.content)) {
      step.log.records.push_back(RecordOf(*log));
    } else {
      step.changes.push_back(std::get<recording::PlayedChange>(item.content).change);
    }
  }

  void end(ReplayStep& step) {
    if (is_cancelled_.Get()) return;
    for (auto& [path, collector] : columns_) collector.flush();
    if (step.events.size() > kListed) {
      step.events.erase(step.events.begin(),
                        step.events.end() - static_cast<std::ptrdiff_t>(kListed));
    }
    step.problems = SentencesOf(playback_->reader().problems());
    step.is_gone = !QFileInfo::exists(file_);
  }

  const Content content_;
  const OpenFile open_file_;
  Flag is_cancelled_;  // the open file refers to it
  QString file_;
  std::unique_ptr<Playback> playback_;
  std::map<std::string, RowCollector> columns_;
};

ReplayReader::ReplayReader(Content content, OpenFile open_file)
    : poster_(std::make_shared<GuiPoster>(this)),
      reel_(std::make_shared<Reel>(content, std::move(open_file))) {}

ReplayReader::~ReplayReader() {
  poster_->detach();
  reel_->cancel();
  thread_.dropWaiting();
  thread_.handOver(std::move(reel_));  // closing a file can take as long as reading it
}

std::int64_t ReplayReader::SampleTime(std::int64_t time, std::int64_t first) {
  return time - first + kBeforeBegin;
}

void ReplayReader::start(std::function<void(Reel&)> task) {
  thread_.start([this, poster = poster_, reel = reel_, task = std::move(task)] {
    try {
      task(*reel);
    } catch (const std::exception& thrown) {
      const QString why = ToQString(std::string("the recording could not be read further: ") +
                                    thrown.what() + "; open it again");
      poster->post([this, why] { Q_EMIT refused(why); });
    }
  });
}

void ReplayReader::open(const QString& file) {
  start([this, poster = poster_, file](Reel& reel) {
    const auto facts = reel.open(file);
    poster->post([this, facts] {
      if (facts) return Q_EMIT opened(*facts);
      Q_EMIT refused(ToQString(facts.error().message));
    });
  });
}

void ReplayReader::jump(std::int64_t time, std::int64_t span, WantedColumns columns) {
  start([this, poster = poster_, time, span, columns = std::move(columns)](Reel& reel) {
    poster->post([this, step = reel.jump(time, span, columns)] { Q_EMIT stepped(step); });
  });
}

void ReplayReader::play(std::int64_t time) {
  start([this, poster = poster_, time](Reel& reel) {
    poster->post([this, step = reel.play(time)] { Q_EMIT stepped(step); });
  });
}

void ReplayReader::add(const std::string& path, std::shared_ptr<ColumnFeed> feed) {
  start([this, poster = poster_, path, feed = std::move(feed)](Reel& reel) {
    poster->post([this, step = reel.add(path, feed)] { Q_EMIT stepped(step); });
  });
}

void ReplayReader::find(ReplayTarget target) {
  start([this, poster = poster_, target](Reel& reel) {
    poster->post([this, time = reel.find(target)] { Q_EMIT found(time); });
  });
}

}  // namespace tendon::gui
