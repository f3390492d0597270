#include <tendon/recording/csv_export.h>

#include <tendon/payload/body_reader.h>
#include <tendon/payload/json.h>
#include <tendon/payload/numeric_field.h>
#include <tendon/recording/export_tables.h>
#include <tendon/recording/row_assembler.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace tendon::recording {
namespace {

bool HasTextOrSequence(const Schema& schema) {
  switch (schema.kind()) {
    case Schema::Kind::kString:
    case Schema::Kind::kSequence:
      return true;
    case Schema::Kind::kArray:
      return HasTextOrSequence(schema.element());
    default:
      return std::ranges::any_of(schema.fields(), [](const Schema::Field& field) {
        return HasTextOrSequence(field.schema);
      });
  }
}

/// Returns the text as a CSV cell, in quotes if necessary.
std::string Cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return text;
  std::string quoted = "\"";
  for (const char letter : text)
    quoted += letter == '"' ? std::string("\"\"") : std::string{letter};
  return quoted + '"';
}

/// Returns a number as JSON, but words (nan, names of enumerators) without quotes.
std::string NumberCell(const NumericField& field, std::span<const std::byte> body) {
  const auto value = ReadExactly(field, body);
  if (!value) return "";
  std::string text = ToJson(field.schema, *value);
  if (text.size() >= 2 && text.front() == '"') text = text.substr(1, text.size() - 2);
  return Cell(text);
}

/// A file name for any text: "robot.arm.state".
std::string FileNameOf(const std::string& path) {
  std::string name;
  for (const char letter : path) {
    const bool is_plain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                          (letter >= '0' && letter <= '9') || letter == '_' || letter == '-';
    name += letter == '/' ? '.' : is_plain ? letter : '_';
  }
  const std::size_t first = name.find_first_not_of('.');
  constexpr std::size_t kLongest = 200;
  return first == name.npos ? "topic" : name.substr(first, kLongest);
}

/// One column of a table, an event, or another topic.
struct CsvMember {
  std::string name;  // empty if the topic has only this member
  Schema schema;
  std::vector<NumericField> numbers;
  bool has_json = false;
};

/// True if the body is exactly one value of this type.
bool IsWhole(const Schema& schema, mcap::ByteView body) {
  payload::CdrReader reader(body);
  return payload::SkipValues(schema, 1, reader) && reader.AtEnd();
}

/// The open files of an export. A recording may have more tables than a process may have files
/// open. Therefore, when one file too many is opened, the file that was written least recently is
/// closed.
class OpenFiles {
 public:
  /// The number of files that are open at once.
  static constexpr std::size_t kMax = 64;

  void Add(const os::PartFile& part, std::unique_ptr<os::WritableFile> file) {
    if (files_.size() == kMax) files_.erase(files_.begin());
    files_.push_back({&part, std::move(file)});
  }
  /// Opens the part, which has `size` bytes, unless it is open. It stays open until the next call.
  Result<os::WritableFile*> Open(const os::PartFile& part,
                                 const os::WritableFile::Identity& identity, std::uint64_t size) {
    const auto found = std::ranges::find(files_, &part, &File::part);
    if (found != files_.end()) {
      std::rotate(found, found + 1, files_.end());
    } else {
      auto file = os::ReopenWritableFile(part.part(), identity, size);
      if (!file) return file.error();
      Add(part, *std::move(file));
    }
    return files_.back().file.get();
  }
  /// Waits until the file that was written last is on the disk, and closes it.
  Result<void> CloseLast() {
    auto synced = files_.back().file->Sync();
    files_.pop_back();
    return synced;
  }

 private:
  struct File {
    const os::PartFile* part = nullptr;
    std::unique_ptr<os::WritableFile> file;
  };
  std::vector<File> files_;  // the file that was written last is at the end
};

/// If too many files are open, adds what to do.
Error WithWayOut(Error error) {
  if (error.message.ends_with(std::generic_category().message(EMFILE))) {
    error.message += " (the export keeps up to " + std::to_string(OpenFiles::kMax) +
                     " files open: raise the limit with ulimit -n)";
  }
  return error;
}

/// Returns how much text of each file waits to be written, in bytes: 64 KiB, or less if there are
/// so many tables that all of it would be more than 64 MiB.
std::size_t MostWaiting(std::size_t tables) {
  constexpr std::size_t kAll = std::size_t{64} << 20U;  // bytes
  constexpr std::size_t kMany = 1024;
  return kAll / std::max(kMany, tables);
}

/// One CSV file. Its rows are assembled from the messages of its channels.
class CsvFile {
 public:
  CsvFile(std::string name, std::vector<CsvMember> members, Content content)
      : name_(std::move(name)),
        members_(std::move(members)),
        content_(content),
        rows_(members_.size()) {}

  Result<void> Create(const std::filesystem::path& folder, OpenFiles& files) {
    auto part = os::PartFile::Create(folder / name_);
    if (!part) return WithWayOut(part.error());
    file_ = folder / name_;
    part_.emplace(*std::move(part));
    auto opened = part_->TakeFile();
    identity_ = opened->identity();
    files.Add(*part_, std::move(opened));
    text_ = "time_ns,source_time_ns,sequence,lost";
    for (const CsvMember& member : members_) {
      for (const NumericField& number : member.numbers) {
        text_ += ',' + Cell(NameOf(member, number.path));
      }
      if (member.has_json) text_ += ',' + Cell(NameOf(member, ""));
    }
    text_ += '\n';
    return {};
  }

  /// Only adds to the text that waits to be written. `clock` is the publish time minus the time on
  /// the clock of the source, ns.
  void Add(std::size_t member, const RowKey& key, const mcap::Message& message, std::int64_t clock,
           CsvReport& report) {
    if (!rows_.Accepts(member, key)) EndRow(rows_.Take(), report);
    rows_.Add(member, key, message);
    clock_ = clock;
  }
  /// The size of the text that waits to be written, bytes.
  [[nodiscard]] std::size_t waiting() const { return text_.size(); }
  Result<void> Write(OpenFiles& files) {
    const auto out = files.Open(*part_, identity_, size_);
    if (!out) return Failure(WithWayOut(out.error()));
    const std::array parts{mcap::ByteView(std::as_bytes(std::span(text_)))};
    if (auto written = (*out)->WriteAt(size_, parts); !written) return Failure(written.error());
    size_ += text_.size();
    text_.clear();
    return {};
  }

  /// Writes everything to the disk, and closes the part file.
  Result<void> Close(OpenFiles& files, CsvReport& report) {
    if (!rows_.is_empty()) EndRow(rows_.Take(), report);
    if (auto written = Write(files); !written) return written;
    auto synced = files.CloseLast();
    return synced ? synced : Failure(synced.error());
  }
  Result<void> Complete() { return part_->Complete(); }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  static std::string NameOf(const CsvMember& member, const std::string& path) {
    if (!member.name.empty()) return member.name + path;
    return path.empty() ? "value" : path.substr(path.front() == '.' ? 1 : 0);
  }

  /// Empty if the value is malformed.
  static std::optional<std::string> CellsOf(const CsvMember& member, mcap::ByteView body) {
    if (!IsWhole(member.schema, body)) return std::nullopt;
    std::string cells;
    for (const NumericField& number : member.numbers) cells += ',' + NumberCell(number, body);
    if (!member.has_json) return cells;
    const auto json = ToJson(member.schema, body);
    if (!json) return std::nullopt;
    return cells + ',' + Cell(*json);
  }
  static std::string EmptyCells(const CsvMember& member) {
    return std::string(member.numbers.size() + (member.has_json ? 1 : 0), ',');
  }

  void EndRow(const AssembledRow& row, CsvReport& report) {
    const RowKey& key = row.key;
    if (content_ == Content::kRows) AddGap(key, report);
    text_ += std::to_string(key.time) + ',' +
             std::to_string(SourceTimeOf(row.publish_time, clock_)) + ',' +
             std::to_string(key.sequence) + ",0";
    bool is_complete = true;
    for (std::size_t i = 0; i < members_.size(); ++i) {
      const auto cells = row.cells[i] ? CellsOf(members_[i], *row.cells[i]) : std::nullopt;
      text_ += cells.value_or(EmptyCells(members_[i]));
      is_complete = is_complete && cells;
    }
    text_ += '\n';
    report.Count(content_);
    if (!is_complete) ++report.incomplete;
    last_ = key;
  }

  void AddGap(const RowKey& key, CsvReport& report) {
    const std::uint32_t missing = MissingRowsBetween(last_, key);
    if (missing == 0) return;
    text_ += std::to_string(key.time) + ",,," + std::to_string(missing);
    for (const CsvMember& member : members_) text_ += EmptyCells(member);
    text_ += '\n';
    report.lost += missing;
  }

  [[nodiscard]] Error Failure(const Error& reason) const {
    return {reason.code,
            "cannot write " + file_.string() + ": " + reason.message + "; no file was written"};
  }

  const std::string name_;
  const std::vector<CsvMember> members_;
  const Content content_;
  std::filesystem::path file_;
  std::optional<os::PartFile> part_;
  os::WritableFile::Identity identity_;
  std::string text_;        // that is not written yet
  std::uint64_t size_ = 0;  // of the file, bytes
  RowAssembler rows_;
  std::int64_t clock_ = 0;  // of the present row
  std::optional<RowKey> last_;
};

CsvMember CsvMemberOf(const ChannelMember& member) {
  CsvMember made{member.name, member.schema, NumericFields(member.schema),
                 HasTextOrSequence(member.schema)};
  if (made.numbers.size() == kMaxNumericFields) made.has_json = true;  // there may be more numbers
  return made;
}

using CsvTables = ExportTables<CsvFile>;

/// kInvalid if there are too many columns.
Result<CsvTables> CsvTablesOf(const mcap::Reader& reader, const mcap::Query& query,
                              const std::filesystem::path& folder, const os::StopRequest& stop) {
  TableNames names;
  std::size_t columns = 0;  // about: a member may have one less
  const auto make =
      [&](const ChannelGroup& group,
          const std::vector<ChannelMember>& members) -> Result<std::shared_ptr<CsvFile>> {
    std::vector<CsvMember> made;
    for (const ChannelMember& member : members) {
      made.push_back(CsvMemberOf(member));
      columns += made.back().numbers.size() + 1;
      if (columns > kMaxColumns) return TooManyColumns(reader);
    }
    return std::make_shared<CsvFile>(names.Take(FileNameOf(group.path), ".csv"), std::move(made),
                                     group.content);
  };
  return MakeTables<CsvFile>(reader, GroupsOf(reader, query), folder, stop, make);
}

Result<void> WriteFiles(mcap::Reader& reader, const mcap::Query& query, const CsvTables& tables,
                        const std::filesystem::path& folder, const os::StopRequest& stop,
                        OpenFiles& files, CsvReport& report) {
  for (const auto& file : tables.all()) {
    if (auto created = file->Create(folder, files); !created) return created;
  }
  const std::size_t most_waiting = MostWaiting(tables.all().size());
  const auto add = [&](const CsvTables::Destination& destination, const RowKey& key,
                       const mcap::Message& message) {
    CsvFile& file = *destination.table;
    file.Add(destination.column, key, message, destination.clock, report);
    return file.waiting() < most_waiting ? Result<void>() : file.Write(files);
  };
  auto added = tables.AddMessages(reader, query, folder, stop, report, add);
  if (!added) return added;
  for (const auto& file : tables.all()) {
    if (auto closed = file->Close(files, report); !closed) return closed;
  }
  return {};
}

Result<CsvReport> Export(mcap::Reader& reader, const mcap::Query& query,
                         const std::filesystem::path& folder, const os::StopRequest& stop) {
  // Both are destroyed after the tables have removed their part files.
  std::unique_ptr<os::Descriptor> lock;
  OpenFiles files;
  const auto tables = CsvTablesOf(reader, query, folder, stop);
  if (!tables) return tables.error();
  lock = os::LockFolder(folder);
  if (!lock) {
    return Error{ErrorCode::kExists, "another program is exporting into " + folder.string() +
                                         ": wait for its end, or choose another folder"};
  }
  CsvReport report;
  auto written = WriteFiles(reader, query, *tables, folder, stop, files, report);
  if (!written) return written.error();
  for (const auto& file : tables->all()) {
    if (auto completed = file->Complete(); !completed) {
      std::error_code ignored;
      for (const auto& complete : report.files) std::filesystem::remove(complete, ignored);
      return completed.error();
    }
    report.files.push_back(file->file());
  }
  return report;
}

}  // namespace

Result<CsvReport> ExportCsv(mcap::Reader& reader, const mcap::Query& query,
                            const std::filesystem::path& folder, const os::StopRequest& stop) {
  std::error_code failed;
  const bool is_new = std::filesystem::create_directories(folder, failed);
  if (failed) {
    return Error{ErrorCode::kFailed, "cannot create " + folder.string() + ": " + failed.message()};
  }
  auto report = Export(reader, query, folder, stop);
  if (!report && is_new) std::filesystem::remove(folder, failed);  // if it is empty
  return report;
}

}  // namespace tendon::recording
