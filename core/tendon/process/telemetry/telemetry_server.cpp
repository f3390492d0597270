#include <tendon/process/telemetry/telemetry_server.h>

#include <tendon/base/os/process.h>
#include <tendon/middleware/broadcast.h>
#include <tendon/process/history/kept_rows.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace tendon {
namespace {

constexpr std::chrono::milliseconds kBetweenBatches(20);

template <typename List>
std::vector<std::string> ListedNames(const List& list) {
  std::vector<std::string> names;
  for (const auto& one : list) names.push_back(one->name());
  return names;
}

/// Returns the newest value of one column, without a handle.
message::MirroredColumn NewestOf(const StateTable& table, std::size_t column) {
  message::MirroredColumn newest;
  newest.capacity = static_cast<std::uint32_t>(table.columns()[column]->layout().bytes);
  std::vector<std::uint64_t> row(table.row_words());
  std::uint64_t tick = 0;
  if (table.CopyNewestRow(tick, row, newest.time) != RowResult::kDone) return newest;
  const auto cell = table.cell(row, column);
  newest.value.assign(cell.begin(), cell.end());
  return newest;
}

}  // namespace

void AcknowledgementQueue::Add(const std::shared_ptr<Channel>& channel, std::uint32_t handle) {
  std::unique_lock lock(mutex_);
  auto& handles = acknowledgements_[channel];
  if (handles.size() < kMaxOfOneViewer || handles.contains(handle)) {
    handles.insert(handle);
    has_some_.Set(true);
    return;
  }
  lock.unlock();
  channel->CutOff("acknowledged rows of more subscriptions than it can have");
}

RowAcknowledgements AcknowledgementQueue::TakeAll() {
  if (!has_some_.Get()) return {};
  const std::scoped_lock lock(mutex_);
  has_some_.Set(false);
  return std::exchange(acknowledgements_, {});
}

TelemetryServer::TelemetryServer(ProcessContext& context, const ProcessHistory& history)
    : context_(context), history_(history) {
  context_.network->Add(*this);
}

TelemetryServer::~TelemetryServer() { context_.network->Remove(*this); }

void TelemetryServer::Subscribe(const std::shared_ptr<Channel>& channel,
                                const message::Subscribe& wanted, Responder& responder) {
  const auto structure = context_.process.LockStructure();
  const auto source = LookUp(wanted);
  if (wanted.rows.period.count() < 0) {
    return responder.Refuse({ErrorCode::kInvalid, "the period of rows must not be below zero"});
  }
  if (!source) return responder.Refuse(source.error());
  message::SubscribeReply subscribed = Describe(*source);
  const std::scoped_lock lock(mutex_);
  if (auto room = HasRoomFor(*source, wanted, *channel); !room) {
    return responder.Refuse(room.error());
  }
  TableFeed& feed = FeedOf(wanted.component, *source->table);
  subscribed.handle = ++last_handle_;
  subscribed.first_tick = feed.next_tick();
  const Lane lane = channel->NewLane();
  // Rows must not overtake the reply.
  if (!responder.TryReply(EncodeBody(subscribed), lane)) return;
  feed.Add(source->columns, wanted.rows, channel, subscribed.handle, lane);
  context_.network->Notify();
}

void TelemetryServer::ReadRows(const message::ReadRows& wanted, Responder& responder) const {
  constexpr std::size_t kMaxBytes = std::size_t{128} << 10U;
  const auto structure = context_.process.LockStructure();
  const auto source = LookUp(message::Subscribe{
      .component = wanted.component, .table = wanted.table, .columns = wanted.columns, .rows = {}});
  if (!source) return responder.Refuse(source.error());
  if (wanted.last.count() < 0) {
    return responder.Refuse({ErrorCode::kInvalid, "the age of rows must not be below zero"});
  }
  const StateTable& table = *source->table;
  const bool is_first = wanted.epoch == 0;
  if (!is_first && wanted.epoch != table.epoch()) {
    return responder.Refuse(
        {ErrorCode::kFailed, context_.name + "/" + wanted.component + "/" + wanted.table +
                                 " was replaced during the reading; read it again"});
  }
  const SteadyTime now = SteadyClock().Now();
  message::ReadRowsReply reply{.subscribed = Describe(*source),
                               .now = now.time_since_epoch().count(),
                               .end_tick = table.next_tick(),
                               .rows = {}};
  const auto history = history_.Lock(table);
  KeptRows rows(table, history.get());
  std::uint64_t tick = is_first ? rows.FirstTick(now - wanted.last) : wanted.first_tick;
  reply.subscribed.first_tick = tick;
  RowBatchWriter batch(CellSizes(table, source->columns));
  std::uint64_t lost = 0;
  while (tick < reply.end_tick && batch.size() < kMaxBytes) {
    const std::uint64_t found = rows.Read(tick, reply.end_tick);
    lost += found - std::exchange(tick, found);
    if (tick == reply.end_tick) break;
    batch.BeginRow(tick++, rows.time());
    for (const std::size_t column : source->columns) batch.AddCell(rows.cell(column));
  }
  const auto body =
      batch.Finish({.rows_before = wanted.rows_before, .lost_table = lost, .next_tick = tick});
  reply.rows.assign(body.begin(), body.end());
  responder.Reply(EncodeBody(reply));
}

message::SubscribeReply TelemetryServer::Describe(const Source& source) {
  message::SubscribeReply subscribed;
  subscribed.epoch = source.table->epoch();
  for (const std::size_t column : source.columns) {
    subscribed.schemas.push_back(source.table->columns()[column]->schema().TextWithHelp());
  }
  return subscribed;
}

void TelemetryServer::JoinTopic(const std::shared_ptr<Channel>& channel,
                                const message::Subscribe& wanted, Responder& responder) {
  const auto structure = context_.process.LockStructure();
  const auto source = LookUp(wanted);
  if (!source) return responder.Refuse(source.error());
  const std::scoped_lock lock(mutex_);
  if (auto fits = FitsTopic(wanted, *source); !fits) return responder.Refuse(fits.error());
  if (auto room = HasRoomFor(*source, wanted, *channel); !room) {
    return responder.Refuse(room.error());
  }
  message::JoinTopicReply joined{.subscribed = Describe(*source), .topic = {}};
  TableFeed& feed = FeedOf(wanted.component, *source->table);
  joined.subscribed.handle = ++last_handle_;
  joined.subscribed.first_tick = feed.next_tick();
  const auto make = [&] {
    std::string name = context_.name + "-" + std::to_string(os::RandomNumber());
    auto topic = context_.middleware->broadcast()->OpenTopic(broker_, name);
    return std::make_unique<RowTopic>(std::move(name), std::move(topic));
  };
  joined.topic = feed.AddToTopic(source->columns, make, channel, joined.subscribed.handle);
  bool is_sent = false;
  CallGuarded("joins a topic", [&] { is_sent = responder.TryReply(EncodeBody(joined)); });
  if (!is_sent) return feed.Remove(*channel, joined.subscribed.handle);
  context_.network->Notify();
}

/// Checks the limits of a viewer. Called with the mutex held.
Result<void> TelemetryServer::HasRoomFor(const Source& source, const message::Subscribe& wanted,
                                         const Channel& viewer) const {
  std::size_t count = 0;
  for (const TableFeed& feed : feeds_) count += feed.SubscriptionsOf(viewer);
  if (count >= kMaxSubscriptions) {
    return Error{
        ErrorCode::kFailed,
        "process '" + context_.name + "' allows a viewer at most " +
            std::to_string(kMaxSubscriptions) + " subscriptions, and " + viewer.peer().name +
            " already has that many: end some of these subscriptions, or request several " +
            "columns of a table in one subscription"};
  }
  const auto feed =
      std::ranges::find_if(feeds_, [&](const TableFeed& one) { return one.IsOf(*source.table); });
  if (feed == feeds_.end()) return {};
  const std::size_t cells = feed->CellsFor(viewer, source.columns, wanted.rows);
  const std::size_t most = kMaxReadings * std::max<std::size_t>(1, source.table->columns().size());
  if (cells <= most) return {};
  return Error{ErrorCode::kFailed,
               "the subscriptions of " + viewer.peer().name + " to " + context_.name + "/" +
                   wanted.component + "/" + wanted.table + " would read " + std::to_string(cells) +
                   " values of each row, but at most " + std::to_string(most) +
                   " are allowed for one viewer: end some of these subscriptions, or give several "
                   "of them the same columns and period"};
}

/// Checks that a topic can carry these rows. Called with the mutex held.
Result<void> TelemetryServer::FitsTopic(const message::Subscribe& wanted,
                                        const Source& source) const {
  if (context_.middleware->broadcast() == nullptr || broker_.empty()) {
    return Error{ErrorCode::kNotFound, "process '" + context_.name + "' has no broker"};
  }
  if (wanted.rows != RowChoice{}) {
    return Error{ErrorCode::kInvalid,
                 "the broker delivers every row, so chosen rows cannot be subscribed through it"};
  }
  std::size_t row = 0;
  for (const std::size_t column : source.columns) {
    row += source.table->columns()[column]->layout().bytes;
  }
  constexpr std::size_t kLargestRow = Broadcast::kMaxMessage / 4;  // half a batch
  if (row <= kLargestRow) return {};
  return Error{ErrorCode::kInvalid,
               "rows of " + std::to_string(row) +
                   " bytes are too large for the broker, which accepts at most " +
                   std::to_string(kLargestRow) + " bytes per row"};
}

void TelemetryServer::SetBroker(const std::string& address) {
  const std::scoped_lock lock(mutex_);
  broker_ = address;
}

Result<TelemetryServer::Source> TelemetryServer::LookUp(const message::Subscribe& wanted) const {
  const std::string where = context_.name + "/" + wanted.component;
  const Component* component = context_.process.LookUpComponent(wanted.component);
  if (component == nullptr) return Error{ErrorCode::kNotFound, "there is no component " + where};
  const auto tables = component->tables();
  const auto table = std::find_if(tables.begin(), tables.end(),
                                  [&](const auto* one) { return one->name() == wanted.table; });
  if (table == tables.end()) {
    return Error{ErrorCode::kNotFound, where + " has no state table '" + wanted.table + "'" +
                                           DidYouMean(wanted.table, ListedNames(tables))};
  }
  Source source{.table = *table, .columns = {}, .enabled = nullptr};
  const auto columns = (*table)->columns();
  std::vector<bool> is_named(columns.size());
  for (const std::string& name : wanted.columns) {
    const auto column = std::find_if(columns.begin(), columns.end(),
                                     [&](const auto& one) { return one->name() == name; });
    if (column == columns.end()) {
      return Error{ErrorCode::kNotFound, where + "/" + wanted.table + " has no column '" + name +
                                             "'" + DidYouMean(name, ListedNames(columns))};
    }
    const auto place = static_cast<std::size_t>(column - columns.begin());
    if (is_named[place]) {
      return Error{ErrorCode::kInvalid, "a subscription to " + where + "/" + wanted.table +
                                            " names column '" + name + "' twice: name it once"};
    }
    is_named[place] = true;
    source.columns.push_back(place);
  }
  return source;
}

void TelemetryServer::Mirror(const std::shared_ptr<Channel>& channel, const message::Mirror& wanted,
                             Responder& responder) {
  const auto structure = context_.process.LockStructure();
  const auto sources = LookUp(wanted);
  if (!sources) return responder.Refuse(sources.error());
  const std::scoped_lock lock(mutex_);
  message::MirrorReply mirrored;
  for (const Source& source : *sources) {
    if (source.table == nullptr) {
      mirrored.columns.emplace_back();
      continue;
    }
    message::MirroredColumn& column =
        mirrored.columns.emplace_back(NewestOf(*source.table, source.columns.front()));
    column.handle = ++last_handle_;
  }
  const Lane lane = channel->NewLane();
  // Rows must not overtake the reply.
  if (!responder.TryReply(EncodeBody(mirrored), lane)) return;
  const RowChoice newest{.delivery = RowDelivery::kNewest};
  for (std::size_t i = 0; i < sources->size(); ++i) {
    const Source& source = (*sources)[i];
    if (source.table == nullptr) continue;
    FeedOf(wanted.provided.component, *source.table)
        .Add(source.columns, newest, channel, mirrored.columns[i].handle, lane);
    mirrored_.Add({.component = wanted.provided.component,
                   .enabled = source.enabled,
                   .channel = channel,
                   .handle = mirrored.columns[i].handle,
                   .lane = lane});
  }
  mirrored_.Report();
  context_.network->Notify();
}

Result<std::vector<TelemetryServer::Source>> TelemetryServer::LookUp(
    const message::Mirror& wanted) const {
  const auto provided = context_.process.LookUpProvided(wanted.provided);
  if (!provided) return provided.error();
  std::set<std::string_view> named;
  std::vector<Source> sources;
  for (const std::string& name : wanted.commands) {
    if (!named.insert(name).second) {
      return Error{ErrorCode::kInvalid, "a request for mirrored values of " +
                                            ToString(wanted.provided) + " names '" + name +
                                            "' twice: name it once"};
    }
    const Offer* command = (*provided)->FindCommand(name);
    if (command == nullptr) {  // reported when the interface is opened
      sources.emplace_back();
      continue;
    }
    const ColumnSource& source = command->source();
    if (source.table == nullptr) {
      return Error{ErrorCode::kIncompatible,
                   "'" + name + "' of " + ToString(wanted.provided) +
                       " cannot be mirrored: it does not read the newest value of a state table"};
    }
    const auto columns = source.table->columns();
    const auto place = std::ranges::find(columns, source.column, &std::unique_ptr<ColumnBase>::get);
    sources.push_back({.table = source.table,
                       .columns = {static_cast<std::size_t>(place - columns.begin())},
                       .enabled = &command->enabled()});
  }
  return sources;
}

TableFeed& TelemetryServer::FeedOf(const std::string& component, const StateTable& table) {
  const auto found = std::find_if(feeds_.begin(), feeds_.end(),
                                  [&](const TableFeed& feed) { return feed.IsOf(table); });
  return found != feeds_.end() ? *found : feeds_.emplace_back(component, table);
}

void TelemetryServer::Unsubscribe(const std::shared_ptr<Channel>& channel, std::uint32_t handle) {
  const std::scoped_lock lock(mutex_);
  for (TableFeed& feed : feeds_) feed.Remove(*channel, handle);
  mirrored_.Remove(*channel, handle);
}

void TelemetryServer::RemoveComponent(const std::string& component) {
  const Error reason{ErrorCode::kNotFound,
                     "component " + context_.name + "/" + component + " was removed"};
  const std::scoped_lock lock(mutex_);
  mirrored_.Remove(component);
  feeds_.remove_if([&](TableFeed& feed) {
    if (feed.component() != component) return false;
    feed.End(reason);
    return true;
  });
}

bool TelemetryServer::HasSentAll() {
  const std::scoped_lock lock(mutex_);
  return std::ranges::all_of(feeds_, [](const TableFeed& feed) { return feed.HasSentAll(); });
}

bool TelemetryServer::Work(SteadyTime now, SteadyTime& next) {
  const std::scoped_lock lock(mutex_);
  if (feeds_.empty()) {
    (void)acknowledgements_.TakeAll();
    return false;
  }
  const bool is_time = now >= next_gathering_;
  const RowAcknowledgements acknowledgements =
      is_time ? acknowledgements_.TakeAll() : RowAcknowledgements();
  bool more = false;
  for (TableFeed& feed : feeds_) {  // one batch of each feed
    if (!acknowledgements.empty()) feed.OnRowsTaken(acknowledgements);
    if (is_time || feed.has_more()) more = feed.Gather() || more;
  }
  if (is_time) {
    feeds_.remove_if([](const TableFeed& feed) { return !feed.has_viewers(); });
    mirrored_.Report();
    next_gathering_ = now + kBetweenBatches;
  }
  next = std::min(next, next_gathering_);
  return more;
}

}  // namespace tendon
