#include <tendon/recording/mcap/copy.h>

#include <exception>
#include <map>
#include <utility>

namespace tendon::mcap {
namespace {

/// The ids in the new file, by the ids in the old file.
struct NewIds {
  std::map<SchemaId, SchemaId> schemas;
  std::map<ChannelId, ChannelId> channels;
};

/// Returns true if the writer has refused an argument. A refused call has changed nothing, so the
/// report mentions it and the copy continues.
bool IsRefused(const Error& error, CopyReport& report) {
  if (error.code != ErrorCode::kInvalid) return false;
  report.problems.push_back({0, error.message});
  return true;
}

/// Adds the schemas and channels that have no new id yet, because reading messages may find more
/// channels.
Result<void> AddDefinitions(const Reader& reader, Writer& writer, NewIds& ids, CopyReport& report) {
  for (const auto& [id, schema] : reader.schemas()) {
    if (ids.schemas.contains(id)) continue;
    const auto added = writer.AddSchema(schema.name, schema.encoding, schema.data);
    if (!added && !IsRefused(added.error(), report)) return added.error();
    ids.schemas.emplace(id, added ? *added : SchemaId{0});
  }
  for (const auto& [id, channel] : reader.channels()) {
    if (ids.channels.contains(id)) continue;
    const auto schema = ids.schemas.find(channel.schema_id);  // a lost one counts as none
    const auto added = writer.AddChannel(schema == ids.schemas.end() ? SchemaId{0} : schema->second,
                                         channel.topic, channel.message_encoding, channel.metadata);
    if (!added) return added.error();
    ids.channels.emplace(id, *added);
  }
  return {};
}

Result<void> CopyMessages(Reader& reader, const Query& query, Writer& writer, NewIds& ids,
                          const os::StopRequest& stop, CopyReport& report) {
  constexpr std::uint64_t kBetweenLooks = 1024;
  std::uint64_t count = 0;
  MessageStream messages = reader.Messages(query);
  while (auto message = messages.Next()) {
    if (++count % kBetweenLooks == 0 && stop && stop()) {
      return Error{ErrorCode::kFailed, "stopped before the copy was complete; no file was written"};
    }
    auto id = ids.channels.find(message->channel_id);
    if (id == ids.channels.end()) {
      if (auto added = AddDefinitions(reader, writer, ids, report); !added) return added;
      id = ids.channels.find(message->channel_id);
    }
    message->channel_id = id->second;
    if (auto written = writer.Write(*message); !written) {
      if (!IsRefused(written.error(), report)) return written;
      continue;
    }
    ++report.messages;
  }
  return {};
}

/// Adds the problems of the reader and of the messages that were skipped here.
void AddProblems(const Reader& reader, CopyReport& report) {
  report.problem_count += report.problems.size() + reader.problems().count();
  report.problems.insert(report.problems.end(), reader.problems().first().begin(),
                         reader.problems().first().end());
}

}  // namespace

Result<CopyReport> Copy(Reader& reader, const Query& query, Writer& writer,
                        const os::StopRequest& stop) try {
  CopyReport report;
  NewIds ids;
  if (auto added = AddDefinitions(reader, writer, ids, report); !added) return added.error();
  for (const MetadataIndex& index : reader.metadata()) {
    const auto metadata = reader.ReadMetadata(index);
    if (!metadata) {
      report.problems.push_back({index.offset, metadata.error().message});
      continue;
    }
    if (auto written = writer.Write(*metadata); !written) {
      if (!IsRefused(written.error(), report)) return written.error();
      continue;
    }
    ++report.metadata;
  }
  for (const AttachmentIndex& index : reader.attachments()) {
    const auto attachment = reader.ReadAttachment(index);
    if (!attachment) {
      report.problems.push_back({index.offset, attachment.error().message});
      continue;
    }
    if (auto written = writer.Write(*attachment); !written) {
      if (!IsRefused(written.error(), report)) return written.error();
      continue;
    }
    ++report.attachments;
  }
  if (auto copied = CopyMessages(reader, query, writer, ids, stop, report); !copied) {
    return copied.error();
  }
  AddProblems(reader, report);
  return report;
} catch (const std::exception& thrown) {
  return Error{ErrorCode::kFailed, std::string("cannot copy a recording: ") + thrown.what()};
}

Result<CopyReport> Copy(Reader& reader, const Query& query, const std::filesystem::path& to,
                        WriterOptions options, const os::StopRequest& stop) {
  options.profile = reader.header().profile;
  auto part = os::PartFile::Create(to);
  if (!part) return part.error();
  auto writer = Writer::Create(part->TakeFile(), options);
  if (!writer) return writer.error();
  auto report = Copy(reader, query, **writer, stop);
  if (!report) return report;
  if (auto closed = (*writer)->Close(); !closed) return closed.error();
  writer->reset();
  if (auto completed = part->Complete(); !completed) return completed.error();
  return report;
}

Result<CopyReport> Recover(const std::filesystem::path& from, const std::filesystem::path& to,
                           const WriterOptions& options, const os::StopRequest& stop) {
  auto opened = os::OpenRandomAccessFile(from);
  if (!opened) return opened.error();
  if ((*opened)->is_being_written()) {
    return Error{ErrorCode::kFailed, "cannot recover " + from.string() +
                                         ": it is still being recorded; stop the recording first"};
  }
  auto reader = Reader::OpenByScan(*std::move(opened));
  if (!reader) return reader.error();
  return Copy(**reader, {.order = Query::Order::kFile}, to, options, stop);
}

}  // namespace tendon::mcap
