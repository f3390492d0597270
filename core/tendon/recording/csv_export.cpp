#include <tendon/payload/json.h>
#include <tendon/payload/numeric_field.h>
#include <tendon/recording/channel_groups.h>
#include <tendon/recording/csv_export.h>
#include <tendon/recording/recording_files.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>

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

/// In quotes if a reader of CSV needs them.
std::string Cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return text;
  std::string quoted = "\"";
  for (const char letter : text)
    quoted += letter == '"' ? std::string("\"\"") : std::string{letter};
  return quoted + '"';
}

/// A number as JSON, but words without quotes: nan, or the name of an enumerator.
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
  std::string name;  // empty if the topic has only this one
  Schema schema;
  std::vector<NumericField> numbers;
  bool has_json = false;
};

/// One CSV file. Its rows are assembled from the messages of its channels.
class CsvFile {
 public:
  CsvFile(std::vector<CsvMember> members, Sequence sequence)
      : members_(std::move(members)), sequence_(sequence), cells_(members_.size()) {}

  Result<void> Create(const std::filesystem::path& file) {
    file_ = file;
    out_.open(file, std::ios::binary);
    out_ << "time_ns,source_time_ns,sequence,lost";
    for (const CsvMember& member : members_) {
      for (const NumericField& number : member.numbers) {
        out_ << ',' << Cell(NameOf(member, number.path));
      }
      if (member.has_json) out_ << ',' << Cell(NameOf(member, ""));
    }
    out_ << '\n';
    return Check();
  }

  /// `run` differs for each start of the source, after which sequences begin again.
  void Add(std::size_t member, const mcap::Message& message, std::int64_t source_time,
           mcap::ChannelId run, CsvReport& report) {
    const Key key{message.log_time, message.sequence, run};
    if (key_ && (!(*key_ == key) || !cells_[member].empty())) Flush(report);
    if (!key_) {
      key_ = key;
      source_time_ = source_time;
    }
    cells_[member] = CellsOf(members_[member], message.data);
  }

  Result<void> Finish(CsvReport& report) {
    Flush(report);
    out_.close();
    return Check();
  }

 private:
  struct Key {
    mcap::Timestamp time = 0;
    std::uint32_t sequence = 0;
    mcap::ChannelId run = 0;

    bool operator==(const Key&) const = default;
  };

  static std::string NameOf(const CsvMember& member, const std::string& path) {
    if (!member.name.empty()) return member.name + path;
    return path.empty() ? "value" : path.substr(path.front() == '.' ? 1 : 0);
  }

  static std::string CellsOf(const CsvMember& member, mcap::Bytes data) {
    const mcap::Bytes body = data.subspan(std::min(data.size(), kEncapsulationSize));
    std::string cells;
    for (const NumericField& number : member.numbers) cells += ',' + NumberCell(number, body);
    if (!member.has_json) return cells;
    const auto json = ToJson(member.schema, body);
    return cells + ',' + (json ? Cell(*json) : "");
  }

  void Flush(CsvReport& report) {
    if (!key_) return;
    const bool follows = sequence_ == Sequence::kTick && last_ && last_->run == key_->run;
    const std::uint32_t step = follows ? key_->sequence - last_->sequence : 1;
    // Ticks of a table only grow; what goes back is no loss, but from a damaged file.
    if (step > 1 && step < 1U << 31U) {
      out_ << key_->time << ",,," << step - 1;
      for (const CsvMember& member : members_) out_ << Commas(member);
      out_ << '\n';
      report.lost += step - 1;
    }
    out_ << key_->time << ',' << source_time_ << ',' << key_->sequence << ",0";
    for (std::size_t i = 0; i < members_.size(); ++i) {
      out_ << (cells_[i].empty() ? Commas(members_[i]) : cells_[i]);
      cells_[i].clear();
    }
    out_ << '\n';
    ++report.rows;
    last_ = std::exchange(key_, std::nullopt);
  }

  /// Empty cells.
  static std::string Commas(const CsvMember& member) {
    return std::string(member.numbers.size() + (member.has_json ? 1 : 0), ',');
  }

  [[nodiscard]] Result<void> Check() const {
    if (out_.good()) return {};
    return Error{ErrorCode::kFailed,
                 "cannot write " + file_.string() + ": " + std::generic_category().message(errno)};
  }

  const std::vector<CsvMember> members_;
  const Sequence sequence_;
  std::filesystem::path file_;
  std::ofstream out_;
  std::vector<std::string> cells_;  // of the row that is being assembled, by member
  std::optional<Key> key_;
  std::int64_t source_time_ = 0;
  std::optional<Key> last_;
};

/// Where the messages of a channel go.
struct Target {
  std::shared_ptr<CsvFile> file;
  std::size_t member = 0;
  std::int64_t clock = 0;
  mcap::ChannelId run = 0;
};

CsvMember CsvMemberOf(const ChannelMember& member) {
  return {member.name, member.schema, NumericFields(member.schema),
          HasTextOrSequence(member.schema)};
}

/// The targets of all channels. Groups with the same path and columns share a file.
class Targets {
 public:
  void Add(const ChannelGroup& group) {
    std::string signature = group.path;
    std::vector<CsvMember> members;
    std::vector<const mcap::Channel*> channels;
    for (const mcap::Channel* channel : group.channels) {
      const auto member = MemberOf(*channel);
      if (!member) continue;
      signature += '\n' + member->name + ' ' + member->schema.TextWithHelp();
      members.push_back(CsvMemberOf(*member));
      channels.push_back(channel);
    }
    if (channels.empty()) return;
    auto& file = files_[signature];
    if (!file) {
      file = std::make_shared<CsvFile>(std::move(members), group.sequence);
      named_.emplace_back(UnusedName(group.path), file);
    }
    for (std::size_t i = 0; i < channels.size(); ++i) {
      targets_[channels[i]->id] = {file, i, ClockOf(*channels[i]), channels.front()->id};
    }
  }

  [[nodiscard]] const Target* Find(mcap::ChannelId id) const {
    const auto found = targets_.find(id);
    return found == targets_.end() ? nullptr : &found->second;
  }
  [[nodiscard]] const std::vector<std::pair<std::string, std::shared_ptr<CsvFile>>>& files() const {
    return named_;
  }

 private:
  std::string UnusedName(const std::string& path) {
    const std::string name = FileNameOf(path);
    std::string unused = name + ".csv";
    for (int i = 2; !names_.insert(unused).second; ++i) {
      unused = name + "-" + std::to_string(i) + ".csv";
    }
    return unused;
  }

  std::map<std::string, std::shared_ptr<CsvFile>> files_;  // by path and members
  std::vector<std::pair<std::string, std::shared_ptr<CsvFile>>> named_;
  std::map<mcap::ChannelId, Target> targets_;
  std::set<std::string> names_;
};

Result<void> CreateFiles(const Targets& targets, const std::filesystem::path& folder,
                         CsvReport& report) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) {
    return Error{ErrorCode::kFailed, "cannot create " + folder.string() + ": " + failed.message()};
  }
  for (const auto& [name, file] : targets.files()) {
    if (!std::filesystem::exists(folder / name, failed)) continue;
    return Error{
        ErrorCode::kExists,
        (folder / name).string() +
            " already exists, and an export does not replace files: choose another folder"};
  }
  for (const auto& [name, file] : targets.files()) {
    if (auto created = file->Create(folder / name); !created) return created;
    report.files.push_back(folder / name);
  }
  return {};
}

}  // namespace

Result<CsvReport> ExportCsv(mcap::Reader& reader, const mcap::Query& query,
                            const std::filesystem::path& folder) {
  Targets targets;
  for (const ChannelGroup& group : GroupsOf(reader, query)) targets.Add(group);
  if (targets.files().empty()) {
    return NothingToExport(reader);
  }
  CsvReport report;
  if (auto created = CreateFiles(targets, folder, report); !created) return created.error();
  mcap::MessageStream messages = reader.Messages(query);
  while (const auto message = messages.Next()) {
    const Target* target = targets.Find(message->channel_id);
    if (target == nullptr) {
      ++report.skipped;
      continue;
    }
    const auto source_time = static_cast<std::int64_t>(message->publish_time) - target->clock;
    target->file->Add(target->member, *message, source_time, target->run, report);
  }
  for (const auto& [name, file] : targets.files()) {
    if (auto finished = file->Finish(report); !finished) return finished.error();
  }
  return report;
}

}  // namespace tendon::recording
