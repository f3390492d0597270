#include <tendon/recording/hdf5/hdf5_module.h>

#include <hdf5.h>
#include <tendon/payload/body_reader.h>
#include <tendon/payload/json.h>
#include <tendon/payload/numeric_value.h>
#include <tendon/recording/export_tables.h>
#include <tendon/recording/row_assembler.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace tendon::recording {
namespace {

/// Thrown where HDF5 fails, and caught by the only function that is exported.
struct Hdf5Failure {
  std::string reason;
};

/// Returns the reason of the operating system; if there is none, the reason of HDF5.
std::string LastReason() {
  std::string reason;
  const auto take = [](unsigned /*depth*/, const H5E_error2_t* error, void* data) -> herr_t {
    auto& text = *static_cast<std::string*>(data);
    if (text.empty() && error->desc != nullptr) text = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take, &reason);
  constexpr std::string_view kSystem = "error message = '";
  const std::size_t begin = reason.find(kSystem);
  if (begin == reason.npos) return reason.empty() ? "unknown reason" : reason;
  const std::size_t text = begin + kSystem.size();
  return reason.substr(text, reason.find('\'', text) - text);
}

template <typename Number>
Number Checked(Number result) {
  if (result < 0) throw Hdf5Failure{LastReason()};
  return result;
}

/// Owns an object of HDF5.
class Handle {
 public:
  using Closer = herr_t (*)(hid_t);

  Handle(hid_t id, Closer close) : id_(Checked(id)), close_(close) {}
  Handle(Handle&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }

  [[nodiscard]] hid_t get() const { return id_; }
  /// Throws if HDF5 cannot write the rest of the data.
  void Close() { Checked(close_(std::exchange(id_, H5I_INVALID_HID))); }

 private:
  hid_t id_;
  const Closer close_;
};

Handle TextType() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  Checked(H5Tset_size(type.get(), H5T_VARIABLE));
  Checked(H5Tset_cset(type.get(), H5T_CSET_UTF8));
  return type;
}

void WriteText(hid_t object, const char* name, const std::string& text) {
  const Handle type = TextType();
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(
      H5Acreate2(object, name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  const char* const letters = text.c_str();
  Checked(H5Awrite(attribute.get(), type.get(), &letters));
}

/// The attributes `names` and `values` of an enum.
void WriteEnumerators(hid_t object, const std::vector<Schema::Enumerator>& enumerators) {
  const hsize_t count = enumerators.size();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  std::vector<const char*> names;
  std::vector<std::int32_t> values;
  for (const Schema::Enumerator& one : enumerators) {
    names.push_back(one.name.c_str());
    values.push_back(one.value);
  }
  const Handle type = TextType();
  const Handle texts(H5Acreate2(object, "names", type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT),
                     H5Aclose);
  Checked(H5Awrite(texts.get(), type.get(), names.data()));
  const Handle numbers(
      H5Acreate2(object, "values", H5T_STD_I32LE, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  Checked(H5Awrite(numbers.get(), H5T_NATIVE_INT32, values.data()));
}

struct NumberType {
  hid_t type;
  std::size_t size;
};

/// The type is the same in the file and in memory, because the host is little-endian.
NumberType NumberTypeOf(Schema::Kind kind) {
  switch (kind) {
    case Schema::Kind::kBool:
    case Schema::Kind::kUint8:
      return {H5T_STD_U8LE, 1};
    case Schema::Kind::kInt8:
      return {H5T_STD_I8LE, 1};
    case Schema::Kind::kInt16:
      return {H5T_STD_I16LE, 2};
    case Schema::Kind::kUint16:
      return {H5T_STD_U16LE, 2};
    case Schema::Kind::kUint32:
      return {H5T_STD_U32LE, 4};
    case Schema::Kind::kInt64:
    case Schema::Kind::kDuration:
      return {H5T_STD_I64LE, 8};
    case Schema::Kind::kUint64:
      return {H5T_STD_U64LE, 8};
    case Schema::Kind::kFloat32:
      return {H5T_IEEE_F32LE, 4};
    case Schema::Kind::kFloat64:
      return {H5T_IEEE_F64LE, 8};
    default:
      return {H5T_STD_I32LE, 4};
  }
}

/// A dataset that grows by rows. Rows are kept until they fill a chunk.
class Dataset {
 public:
  /// `axes` are those of one row.
  Dataset(std::string name, Schema type, std::string unit, std::vector<hsize_t> axes)
      : name_(std::move(name)),
        type_(std::move(type)),
        unit_(std::move(unit)),
        axes_(std::move(axes)),
        is_text_(type_.kind() == Schema::Kind::kString) {
    for (const hsize_t axis : axes_) in_row_ *= axis;
    constexpr hsize_t kChunk = hsize_t{64} << 10U;  // bytes
    const hsize_t size = is_text_ ? sizeof(char*) : NumberTypeOf(type_.kind()).size;
    chunk_rows_ = std::max<hsize_t>(1, kChunk / std::max<hsize_t>(1, size * in_row_));
  }

  void Create(hid_t group) {
    const Handle type = TextType();
    memory_type_.emplace(H5Tcopy(is_text_ ? type.get() : NumberTypeOf(type_.kind()).type),
                         H5Tclose);
    std::vector<hsize_t> now{0};
    std::vector<hsize_t> most{H5S_UNLIMITED};
    std::vector<hsize_t> chunk{chunk_rows_};
    for (std::vector<hsize_t>* sizes : {&now, &most, &chunk}) {
      sizes->insert(sizes->end(), axes_.begin(), axes_.end());
    }
    const int rank = static_cast<int>(now.size());
    const Handle space(H5Screate_simple(rank, now.data(), most.data()), H5Sclose);
    const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    Checked(H5Pset_chunk(creation.get(), rank, chunk.data()));
    if (!is_text_) {  // the texts are elsewhere in the file, and no filter is applied to them
      constexpr unsigned kLevel = 4;
      Checked(H5Pset_shuffle(creation.get()));
      Checked(H5Pset_deflate(creation.get(), kLevel));
    }
    const Handle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
    Checked(H5Pset_chunk_cache(access.get(), 0, 0, 1.0));  // whole chunks are written at once
    const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    Checked(H5Pset_create_intermediate_group(links.get(), 1));
    Checked(H5Pset_char_encoding(links.get(), H5T_CSET_UTF8));
    dataset_.emplace(H5Dcreate2(group, name_.c_str(), memory_type_->get(), space.get(), links.get(),
                                creation.get(), access.get()),
                     H5Dclose);
    if (!unit_.empty()) WriteText(dataset_->get(), "unit", unit_);
    if (type_.kind() == Schema::Kind::kBool) {
      WriteEnumerators(dataset_->get(), {{"false", 0}, {"true", 1}});
    } else if (type_.kind() == Schema::Kind::kEnum) {
      WriteEnumerators(dataset_->get(), type_.enumerators());
    }
  }

  /// Adds numbers of the row that is being read.
  void AddBytes(const void* numbers, std::size_t size) {
    const auto* bytes = static_cast<const std::byte*>(numbers);
    numbers_.insert(numbers_.end(), bytes, bytes + size);
  }
  void AddText(std::string text) {
    text_size_ += text.size();
    texts_.push_back(std::move(text));
  }
  template <typename Number>
  void AddRow(Number number) {
    AddBytes(&number, sizeof number);
    EndRow();
  }

  void EndRow() {
    constexpr std::size_t kMaxText = std::size_t{1} << 20U;  // bytes
    if (++rows_ - written_ == chunk_rows_ || text_size_ > kMaxText) Write();
  }
  /// Drops the numbers that were added since the last EndRow().
  void DropRow() {
    const auto kept = static_cast<std::size_t>((rows_ - written_) * in_row_);
    if (is_text_) {
      texts_.resize(std::min(texts_.size(), kept));
    } else {
      numbers_.resize(std::min(numbers_.size(), kept * NumberTypeOf(type_.kind()).size));
    }
  }
  void Write() {
    if (rows_ == written_) return;
    std::vector<hsize_t> size{rows_};
    std::vector<hsize_t> count{rows_ - written_};
    std::vector<hsize_t> start{written_};
    size.insert(size.end(), axes_.begin(), axes_.end());
    count.insert(count.end(), axes_.begin(), axes_.end());
    start.resize(size.size());
    Checked(H5Dset_extent(dataset_->get(), size.data()));
    const Handle file(H5Dget_space(dataset_->get()), H5Sclose);
    Checked(H5Sselect_hyperslab(file.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(),
                                nullptr));
    const Handle memory(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr),
                        H5Sclose);
    std::vector<const char*> letters;
    for (const std::string& text : texts_) letters.push_back(text.c_str());
    const void* data = is_text_ ? static_cast<const void*>(letters.data()) : numbers_.data();
    Checked(H5Dwrite(dataset_->get(), memory_type_->get(), memory.get(), file.get(), H5P_DEFAULT,
                     data));
    written_ = rows_;
    numbers_.clear();
    texts_.clear();
    text_size_ = 0;
  }
  void Close() {
    Write();
    dataset_->Close();
  }

 private:
  const std::string name_;
  const Schema type_;
  const std::string unit_;
  const std::vector<hsize_t> axes_;
  const bool is_text_;
  hsize_t in_row_ = 1;
  hsize_t chunk_rows_ = 1;
  std::optional<Handle> memory_type_;
  std::optional<Handle> dataset_;
  std::vector<std::byte> numbers_;
  std::vector<std::string> texts_;
  std::size_t text_size_ = 0;  // bytes
  hsize_t rows_ = 0;
  hsize_t written_ = 0;
};

/// A type with the datasets of its numbers and texts. Elements of an array share them.
struct Node {
  Schema schema;
  Dataset* dataset = nullptr;  // of a number or a text
  std::vector<Node> parts;     // the fields, or the element of an array
};

/// The datasets of one column, event or other topic.
class Column {
 public:
  Column(const std::string& name, const Schema& schema) : schema_(schema) {
    root_ = Add(schema, name, "", {});
    if (has_sequence_) json_ = &Make(name + ".json", Schema(Schema::Kind::kString), "", {});
  }

  /// False if the body is malformed; then the row must be dropped.
  bool Read(mcap::ByteView body) {
    payload::CdrReader reader(body);
    if (!Read(root_, reader) || !reader.AtEnd()) return false;
    if (json_ == nullptr) return true;
    auto json = ToJson(schema_, body);
    if (!json) return false;
    json_->AddText(*std::move(json));
    return true;
  }

  [[nodiscard]] const std::vector<std::unique_ptr<Dataset>>& datasets() const { return datasets_; }

 private:
  Dataset& Make(const std::string& name, const Schema& type, const std::string& unit,
                std::vector<hsize_t> axes) {
    datasets_.push_back(std::make_unique<Dataset>(name, type, unit, std::move(axes)));
    return *datasets_.back();
  }

  Node Add(const Schema& schema, const std::string& path, const std::string& unit,
           const std::vector<hsize_t>& axes) {
    Node node{schema, nullptr, {}};
    constexpr std::size_t kMaxAxes = H5S_MAX_RANK - 1;
    switch (schema.kind()) {
      case Schema::Kind::kStructure:
        for (const Schema::Field& field : schema.fields()) {
          node.parts.push_back(Add(field.schema, path + "/" + field.name,
                                   field.unit.empty() ? unit : field.unit, axes));
        }
        break;
      case Schema::Kind::kArray: {
        std::vector<hsize_t> inner = axes;
        inner.push_back(schema.length());
        if (inner.size() > kMaxAxes) throw Hdf5Failure{path + " has more than 31 axes"};
        node.parts.push_back(Add(schema.element(), path, unit, inner));
        break;
      }
      case Schema::Kind::kSequence:
        has_sequence_ = true;
        break;
      default: {
        const bool is_duration = schema.kind() == Schema::Kind::kDuration;
        node.dataset = &Make(path, schema, is_duration ? "ns" : unit, axes);
      }
    }
    return node;
  }

  bool Read(const Node& node, payload::CdrReader& reader) {
    switch (node.schema.kind()) {
      case Schema::Kind::kStructure:
        if (node.schema.is_none()) return reader.Skip(1, 1);
        return std::ranges::all_of(node.parts,
                                   [&](const Node& part) { return Read(part, reader); });
      case Schema::Kind::kArray:
        for (std::uint32_t i = 0; i < node.schema.length(); ++i) {
          if (!Read(node.parts.front(), reader)) return false;
        }
        return true;
      case Schema::Kind::kSequence:
        return payload::SkipValues(node.schema, 1, reader);
      case Schema::Kind::kString: {
        std::string_view text;
        if (!reader.ReadString(text)) return false;
        node.dataset->AddText(std::string(text));
        return true;
      }
      case Schema::Kind::kDuration: {
        payload::CdrDuration duration;
        if (!payload::ReadDuration(reader, duration)) return false;
        const std::int64_t nanoseconds = NumericValue(duration).integer();
        node.dataset->AddBytes(&nanoseconds, sizeof nanoseconds);
        return true;
      }
      default:
        return payload::WithNumber(node.schema.kind(), [&](auto number) {
          if (!reader.Read(number)) return false;
          node.dataset->AddBytes(&number, sizeof number);
          return true;
        });
    }
  }

  const Schema schema_;
  Node root_;
  bool has_sequence_ = false;
  Dataset* json_ = nullptr;
  std::vector<std::unique_ptr<Dataset>> datasets_;
};

/// A group of the file. Its rows are assembled from the messages of its channels.
class Table {
 public:
  Table(std::string name, Content content, const std::vector<ChannelMember>& members)
      : name_(std::move(name)),
        content_(content),
        ticks_(content == Content::kRows ? "tick" : "sequence", kUnsigned, "", {}) {
    for (const ChannelMember& member : members) {
      const std::string column = member.name.empty() ? "value" : member.name;
      // A column may have the name of one of our datasets.
      columns_.push_back(
          std::make_unique<Column>(kTaken.contains(column) ? column + "_" : column, member.schema));
    }
    row_.emplace(columns_.size());
  }

  void Create(hid_t file) {
    const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    Checked(H5Pset_create_intermediate_group(links.get(), 1));
    Checked(H5Pset_char_encoding(links.get(), H5T_CSET_UTF8));
    const Handle group(H5Gcreate2(file, name_.c_str(), links.get(), H5P_DEFAULT, H5P_DEFAULT),
                       H5Gclose);
    for (Dataset* dataset : All()) dataset->Create(group.get());
  }

  /// `clock` is the publish time minus the time on the clock of the source, ns.
  void Add(std::size_t member, const RowKey& key, const mcap::Message& message, std::int64_t clock,
           Hdf5Report& report) {
    if (!row_->Accepts(member, key)) EndRow(row_->Take(), report);
    row_->Add(member, key, message);
    clock_ = clock;
  }

  void Close(Hdf5Report& report) {
    if (!row_->is_empty()) EndRow(row_->Take(), report);
    for (Dataset* dataset : All()) dataset->Close();
  }

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  inline static const std::set<std::string> kTaken{"time_ns",  "source_time_ns", "tick",
                                                   "sequence", "starts",         "gaps"};
  inline static const Schema kSigned{Schema::Kind::kInt64};
  inline static const Schema kUnsigned{Schema::Kind::kUint64};

  std::vector<Dataset*> All() {
    std::vector<Dataset*> all{&times_, &source_times_, &ticks_};
    if (content_ == Content::kRows) {
      for (Dataset* one : {&starts_, &gap_rows_, &gap_sizes_, &gap_begins_, &gap_ends_}) {
        all.push_back(one);
      }
    }
    for (const auto& column : columns_) {
      for (const auto& dataset : column->datasets()) all.push_back(dataset.get());
    }
    return all;
  }

  void EndRow(const AssembledRow& row, Hdf5Report& report) {
    const RowKey& key = row.key;
    bool is_complete = true;
    for (std::size_t i = 0; i < columns_.size() && is_complete; ++i) {
      is_complete = row.cells[i] && columns_[i]->Read(*row.cells[i]);
    }
    for (const auto& column : columns_) {
      for (const auto& dataset : column->datasets()) {
        is_complete ? dataset->EndRow() : dataset->DropRow();
      }
    }
    if (!is_complete) {
      ++report.incomplete;
      return;
    }
    if (content_ == Content::kRows) AddGap(key, report);
    const bool is_start = !last_ || last_->run != key.run;
    const auto step = static_cast<std::int32_t>(key.sequence - (last_ ? last_->sequence : 0));
    tick_ = is_start ? key.sequence : tick_ + static_cast<std::uint64_t>(std::int64_t{step});
    times_.AddRow(static_cast<std::int64_t>(key.time));
    source_times_.AddRow(SourceTimeOf(row.publish_time, clock_));
    ticks_.AddRow(tick_);
    if (is_start && content_ == Content::kRows) starts_.AddRow(rows_);
    ++rows_;
    report.Count(content_);
    last_ = key;
  }

  void AddGap(const RowKey& key, Hdf5Report& report) {
    const std::uint32_t missing = MissingRowsBetween(last_, key);
    if (missing == 0) return;
    gap_rows_.AddRow(rows_);
    gap_sizes_.AddRow(std::int64_t{missing});
    gap_begins_.AddRow(static_cast<std::int64_t>(last_->time));
    gap_ends_.AddRow(static_cast<std::int64_t>(key.time));
    report.lost += missing;
  }

  const std::string name_;
  const Content content_;
  Dataset times_{"time_ns", kSigned, "ns", {}};
  Dataset source_times_{"source_time_ns", kSigned, "ns", {}};
  Dataset ticks_;
  Dataset starts_{"starts", kSigned, "", {}};
  Dataset gap_rows_{"gaps/row", kSigned, "", {}};
  Dataset gap_sizes_{"gaps/missing", kSigned, "", {}};
  Dataset gap_begins_{"gaps/begin_ns", kSigned, "ns", {}};
  Dataset gap_ends_{"gaps/end_ns", kSigned, "ns", {}};
  std::vector<std::unique_ptr<Column>> columns_;
  std::optional<RowAssembler> row_;
  std::int64_t clock_ = 0;  // of the present row
  std::optional<RowKey> last_;
  std::uint64_t tick_ = 0;
  std::int64_t rows_ = 0;
};

/// A name of a group for any text: "/robot/arm/state".
std::string GroupNameOf(const std::string& path) {
  std::string name;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    std::string step = path.substr(begin, end - begin);
    step.erase(std::remove(step.begin(), step.end(), '\0'), step.end());
    if (step == ".") step = "_";  // means this group
    if (!step.empty()) name += "/" + step;
    begin = end + 1;
  }
  return name.empty() ? "/topic" : name;
}

/// Returns the number of datasets of a column, or a little more. Returns at least 1, so that empty
/// columns count, too.
std::size_t DatasetsOf(const Schema& schema) {
  if (schema.kind() == Schema::Kind::kArray) return DatasetsOf(schema.element());
  std::size_t count = 1;
  for (const Schema::Field& field : schema.fields()) count += DatasetsOf(field.schema);
  return count;
}

/// A channel may be empty, because `gcm cut` keeps all channels.
bool HasMessages(const mcap::Reader& reader, const mcap::Channel& channel) {
  const auto& statistics = reader.statistics();
  return !statistics || statistics->channel_message_counts.empty() ||
         statistics->channel_message_counts.contains(channel.id);
}

using Hdf5Tables = ExportTables<Table>;

/// kInvalid if there are too many columns.
Result<Hdf5Tables> Hdf5TablesOf(const mcap::Reader& reader, const mcap::Query& query,
                                const std::filesystem::path& file, const os::StopRequest& stop) {
  TableNames names;
  std::size_t columns = 0;  // about
  const auto make =
      [&](const ChannelGroup& group,
          const std::vector<ChannelMember>& members) -> Result<std::shared_ptr<Table>> {
    for (const ChannelMember& member : members) {
      columns += DatasetsOf(member.schema);
      if (columns > kMaxColumns) return TooManyColumns(reader);
    }
    return std::make_shared<Table>(names.Take(GroupNameOf(group.path)), group.content, members);
  };
  std::vector<ChannelGroup> groups = GroupsOf(reader, query);
  for (ChannelGroup& group : groups) {
    std::erase_if(group.channels,
                  [&](const mcap::Channel* channel) { return !HasMessages(reader, *channel); });
  }
  return MakeTables<Table>(reader, groups, file, stop, make);
}

/// Throws if HDF5 fails.
Result<void> WriteTables(mcap::Reader& reader, const mcap::Query& query, const Hdf5Tables& tables,
                         const std::filesystem::path& file, Handle& out,
                         const os::StopRequest& stop, Hdf5Report& report) {
  WriteText(out.get(), "recording", std::filesystem::path(reader.name()).filename().string());
  for (const auto& table : tables.all()) {
    table->Create(out.get());
    report.groups.push_back(table->name());
  }
  const auto add = [&report](const Hdf5Tables::Destination& destination, const RowKey& key,
                             const mcap::Message& message) -> Result<void> {
    destination.table->Add(destination.column, key, message, destination.clock, report);
    return {};
  };
  auto added = tables.AddMessages(reader, query, file, stop, report, add);
  if (!added) return added;
  for (const auto& table : tables.all()) table->Close(report);
  Checked(H5Fflush(out.get(), H5F_SCOPE_GLOBAL));
  out.Close();
  return {};
}

Result<Hdf5Report> Export(mcap::Reader& reader, const mcap::Query& query,
                          const std::filesystem::path& file, const os::StopRequest& stop) {
  // Without these calls, HDF5 would print its errors, and at the exit of the program it would
  // repeat failed writes.
  H5dont_atexit();
  H5open();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  auto part = os::PartFile::Create(file);
  if (!part) return part.error();
  part->TakeFile().reset();  // HDF5 opens and locks it itself
  Hdf5Report report;
  try {
    std::optional<Handle> out;  // destroyed after the datasets in it
    const auto tables = Hdf5TablesOf(reader, query, file, stop);
    if (!tables) return tables.error();
    out.emplace(H5Fcreate(part->part().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
    auto written = WriteTables(reader, query, *tables, file, *out, stop, report);
    if (!written) return written.error();
  } catch (const Hdf5Failure& failure) {
    return Error{ErrorCode::kFailed,
                 "cannot write " + file.string() + ": " + failure.reason + "; no file was written"};
  }
  if (auto completed = part->Complete(); !completed) return completed.error();
  return report;
}

}  // namespace
}  // namespace tendon::recording

extern "C" const char* TendonHdf5Build();

const char* TendonHdf5Build() {
  static const std::string build = tendon::recording::Hdf5Build();
  return build.c_str();
}

extern "C" void TendonExportHdf5(tendon::mcap::Reader& reader, const tendon::mcap::Query& query,
                                 const std::filesystem::path& file,
                                 const tendon::os::StopRequest& stop,
                                 tendon::Result<tendon::recording::Hdf5Report>& report);

void TendonExportHdf5(tendon::mcap::Reader& reader, const tendon::mcap::Query& query,
                      const std::filesystem::path& file, const tendon::os::StopRequest& stop,
                      tendon::Result<tendon::recording::Hdf5Report>& report) {
  report = tendon::recording::Export(reader, query, file, stop);
}
