#include <tendon/process/membership/membership.h>

#include <tendon/base/log.h>
#include <tendon/base/os/route.h>
#include <tendon/base/text.h>
#include <tendon/middleware/large_message_in_progress.h>
#include <tendon/process/ask.h>
#include <tendon/process/broadcast_messages.h>
#include <tendon/process/channel_opening.h>
#include <tendon/process/log/log_messages.h>
#include <tendon/process/membership/advertised_address.h>
#include <tendon/process/schema_exchange.h>

#include <algorithm>
#include <utility>

namespace tendon {
namespace {

constexpr std::chrono::milliseconds kGcmOpenTimeout(1000);
constexpr std::chrono::milliseconds kJoinTimeout(2000);
constexpr std::chrono::milliseconds kLeaveTimeout(300);
constexpr std::chrono::milliseconds kBeginTimeout(1000);
constexpr std::chrono::milliseconds kBetweenRenewals(250);
constexpr std::chrono::milliseconds kRenewalTimeout(500);
constexpr std::chrono::milliseconds kSilence(1500);  // after this silence, the GCM is lost

}  // namespace

/// The handler of the channel to the GCM. It posts all work that may block to the worker.
class Membership::GcmHandler final : public ChannelHandler {
 public:
  GcmHandler(std::shared_ptr<Worker> worker, Membership& membership)
      : worker_(std::move(worker)), membership_(membership) {}

 private:
  void OnRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                 std::span<const std::byte> body, Responder responder) override {
    const auto shared = std::make_shared<Responder>(std::move(responder));
    if (header.type == message::kMakeConnection) {
      const auto plan = DecodeBody<message::ConnectionPlan>(body);
      if (!plan) return shared->Refuse(plan.error());
      worker_->Post([&membership = membership_, plan = *plan, shared] {
        membership.delegate_.MakeConnection(plan, [&membership, shared](const auto& made) {
          membership.Report();  // the GCM must have the report before its viewers get the reply
          shared->ReplyWith(made);
        });
      });
    } else if (header.type == message::kBreakConnection) {
      const auto ends = DecodeBody<message::ConnectionEnds>(body);
      if (!ends) return shared->Refuse(ends.error());
      worker_->Post([&membership = membership_, required = ends->required, shared] {
        const auto broken = membership.delegate_.BreakConnection(required);
        membership.Report();
        shared->ReplyWith(broken);
      });
    } else if (header.type == message::kLifecycleOrder) {
      const auto order = DecodeBody<message::LifecycleOrder>(body);
      if (!order) return shared->Refuse(order.error());
      const auto begin = [channel, id = order->id]() -> Result<void> {
        const message::BeginOrder asked{id};
        const auto begun = channel->Call<None>(message::kBeginOrder, 0, asked, kBeginTimeout);
        return begun ? Result<void>() : begun.error();
      };
      worker_->Post([&membership = membership_, order = *order, begin, shared] {
        const auto done = [&membership, shared](const auto& outcome) {
          membership.Report();
          shared->ReplyWith(outcome);
        };
        membership.delegate_.ExecuteOrder(order, begin, done);
      });
    } else if (header.type == message::kGetClasses) {
      worker_->Post([&membership = membership_, shared] {
        membership.delegate_.ListClasses([shared](const auto& all) { shared->ReplyWith(all); });
      });
    } else if (header.type == message::kSetLogLevel) {
      const auto order = DecodeBody<message::SetLogLevel>(body);
      if (order) SetLogLevel(order->level);
      shared->ReplyWith(order ? Result<void>() : order.error());
    } else if (header.type == message::kGetSchemas) {
      ReplyWithSchemas(body, *shared);
    } else {
      ChannelHandler::OnRequest(channel, header, body, std::move(*shared));
    }
  }

  void OnNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                std::span<const std::byte> body) override {
    if (header.type != message::kPeers) return;
    const auto peers = DecodeBody<message::PeerList>(body);
    if (!peers) return;
    worker_->Post([&membership = membership_, processes = peers->processes] {
      membership.delegate_.OnPeers(processes);
    });
  }

  void OnClosed(const std::shared_ptr<Channel>& channel, const Error& reason) override {
    worker_->Post(
        [&membership = membership_, channel, reason] { membership.OnClosed(channel, reason); });
  }

  const std::shared_ptr<Worker> worker_;
  Membership& membership_;  // used only on the worker
};

Membership::Membership(ProcessContext& context, MembershipDelegate& delegate, Options options)
    : context_(context), delegate_(delegate), options_(std::move(options)), log_(context_.network) {
  lease_thread_.Add(*this);
}

Membership::~Membership() { lease_thread_.Remove(*this); }

void Membership::Begin() {
  context_.worker->Post([this] { Try(); });
}

void Membership::Leave() {
  std::shared_ptr<Channel> channel;
  {
    const std::scoped_lock lock(mutex_);
    channel = std::exchange(channel_, nullptr);
  }
  log_.Finish();
  if (channel) (void)channel->Call<None>(message::kLeave, 0, None{}, kLeaveTimeout);
  if (channel) channel->Close();
  if (candidate_) candidate_->Close();
}

Result<void> Membership::WaitUntilJoined(std::chrono::milliseconds timeout) const {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, timeout, [this] {
    return channel_ || (failure_ && (IsFinal(failure_->code) || !options_.retry));
  });
  if (channel_) return {};
  if (failure_) return *failure_;
  return Error{ErrorCode::kTimeout,
               "the GCM at " + options_.gcm + " has not answered within " + Milliseconds(timeout)};
}

bool Membership::is_joined() const {
  const std::scoped_lock lock(mutex_);
  return channel_ != nullptr;
}

void Membership::Try() {
  ChannelRequest wanted{.opener = context_.gcm_opener,
                        .address = options_.gcm,
                        .hello = context_.hello,
                        .handler = std::make_shared<GcmHandler>(context_.worker, *this),
                        .timeout = kGcmOpenTimeout};
  wanted.hello.wanted = kGcmName;
  OpenChannel(context_, wanted, [this](const OpenedChannel& channel) {
    if (!channel) return Fail(WhyNotThere(channel.error()));
    candidate_ = *channel;
    AskForBroker(*channel);
  });
}

Error Membership::WhyNotThere(const Error& error) const {
  const bool is_away = error.code == ErrorCode::kUnreachable || error.code == ErrorCode::kTimeout;
  return is_away ? NoGcm(options_.gcm, error.message) : error;
}

/// Asks the GCM for the address of the broker. Called before viewers can see this process, because
/// they may subscribe to rows at once.
void Membership::AskForBroker(const std::shared_ptr<Channel>& channel) {
  Ask<message::BrokerAddress>(
      *context_.worker, channel, message::kGetBroker, None{}, kJoinTimeout,
      [this, worker = context_.worker, channel](const Result<message::BrokerAddress>& place) {
        worker->Post([this, channel, place] {
          if (!place && place.error().code == ErrorCode::kTimeout) {
            return Finish(channel, {}, place.error());
          }
          if (place) delegate_.OnBroker(place->address);
          Join(channel);
        });
      });
}

void Membership::Join(const std::shared_ptr<Channel>& channel) {
  ProcessContent content = delegate_.content();
  const message::Join join{.process = Myself(content, channel->peer_address()),
                           .components = content.components,
                           .connections = content.connections};
  Ask<message::JoinReply>(
      *context_.worker, channel, message::kJoin, join, kJoinTimeout,
      [this, worker = context_.worker, channel,
       content = std::move(content)](const Result<message::JoinReply>& joined) {
        worker->Post([this, channel, content, joined] { Finish(channel, content, joined); });
      });
}

/// Returns the description of this process for the GCM. `gcm` is a numeric address, because
/// resolving a name may take long. Called for each attempt to join, because the addresses of the
/// GCM and of this host may change.
ProcessDescription Membership::Myself(const ProcessContent& content, const std::string& gcm) {
  const auto place = ParseAddress(gcm, 1);
  const std::string from = place ? os::AddressTowards(place->host, place->port) : std::string();
  const AdvertisedAddress own =
      AdvertisedAddressOf(options_.listens, options_.advertise, {.to = gcm, .from = from});
  Warn(own.warning);
  delegate_.OnOwnAddress(own.address);
  options_.process.address = own.address;
  return Description(content);
}

ProcessDescription Membership::Description(const ProcessContent& content) const {
  ProcessDescription description = options_.process;
  description.plugins = content.plugins;
  return description;
}

void Membership::Finish(const std::shared_ptr<Channel>& channel, ProcessContent reported,
                        const Result<message::JoinReply>& joined) {
  candidate_ = nullptr;
  if (!joined || !channel->is_open()) {
    channel->Close();
    return Fail(joined ? Error{ErrorCode::kUnreachable, "the GCM closed the connection"}
                       : joined.error());
  }
  context_.hello.session = joined->session;
  reported_ = std::move(reported);
  backoff_.Reset();
  SetJoined(channel);
  delegate_.OnPeers(joined->processes);
  Log("joined the GCM at " + options_.gcm + " as process '" + context_.name + "'");
  Report();
}

void Membership::SetJoined(std::shared_ptr<Channel> channel) {
  {
    const std::scoped_lock lock(mutex_);
    channel_ = channel;
    failure_.reset();
    last_renewed_->Set(SteadyClock().Now());
    next_renewal_ = last_renewed_->Get() + kBetweenRenewals;
  }
  changed_.notify_all();
  lease_thread_.Notify();
  log_.SetChannel(std::move(channel));
}

void Membership::Fail(const Error& error) {
  {
    const std::scoped_lock lock(mutex_);
    failure_ = error;
  }
  changed_.notify_all();
  if (!options_.retry) return;
  Log(IsFinal(error.code) ? "keeps running, but is not registered: " + error.message
                          : error.message);
  TryLater();
}

void Membership::OnClosed(const std::shared_ptr<Channel>& channel, const Error& reason) {
  {
    const std::scoped_lock lock(mutex_);
    if (channel_ != channel) return;
    channel_ = nullptr;
    failure_ =
        Error{ErrorCode::kUnreachable, "the connection to the GCM was lost: " + reason.message};
  }
  log_.SetChannel(nullptr);
  Log("the GCM at " + options_.gcm + " was lost (" + reason.message +
      "); this process keeps running and tries to reconnect");
  backoff_.Reset();
  if (options_.retry) TryLater();
}

void Membership::TryLater() {
  context_.worker->PostAfter(backoff_.Next(), [this] { Try(); });
}

void Membership::ReportSoon() {
  {
    const std::scoped_lock lock(mutex_);
    if (std::exchange(is_report_due_, true)) return;
  }
  context_.worker->Post([this] { Report(); });
}

void Membership::Report() {
  constexpr std::chrono::milliseconds kUntilLinkHasRoom(20);
  std::shared_ptr<Channel> channel;
  {
    const std::scoped_lock lock(mutex_);
    is_report_due_ = false;
    channel = channel_;
  }
  if (!channel) return;  // the next join reports everything
  ProcessContent content = delegate_.content();
  message::Report report{.changes = Differences(reported_, content)};
  if (content.plugins != reported_.plugins) {
    CatalogueChange& change = report.changes.emplace_back();
    change.kind = CatalogueChange::Kind::kProcess;
    change.processes = {Description(content)};
  }
  if (report.changes.empty()) return;
  if (channel->Notify(message::kReport, 0, report) == Status(Status::kQueueFull)) {
    return context_.worker->PostAfter(kUntilLinkHasRoom, [this] { ReportSoon(); });
  }
  reported_ = std::move(content);
}

bool Membership::Work(SteadyTime now, SteadyTime& next) {
  std::shared_ptr<Channel> channel;
  bool is_silent = false;
  bool is_due = false;
  {
    const std::scoped_lock lock(mutex_);
    if (!channel_) return false;
    channel = channel_;
    // A large message may delay our request or the GCM's reply.
    const SteadyTime lost =
        std::max({last_renewed_->Get(), channel->last_part(), LargeMessageInProgress::Last(now)}) +
        kSilence;
    is_silent = now >= lost;
    is_due = now >= next_renewal_;
    if (is_due) next_renewal_ = now + kBetweenRenewals;
    next = std::min({next, next_renewal_, lost});
  }
  if (is_silent) {
    channel->Close();
  } else if (is_due) {
    channel->Expire(now);
    Renew(channel);
  }
  if (!is_silent) health_.Work(channel, now, next);
  return false;
}

void Membership::Renew(const std::shared_ptr<Channel>& channel) {
  channel->Request<None>(
      message::kRenew, 0, None{}, kRenewalTimeout,
      [last_renewed = last_renewed_, channel](const Result<None>& renewed) {
        if (renewed) {
          last_renewed->Set(SteadyClock().Now());
        } else if (renewed.error().code == ErrorCode::kDenied) {
          channel->Close();  // the membership has ended: join again
        }
      },
      kOwnLane);
}

/// Logs a line if it differs from the last one. Text in brackets, such as a time, is not compared.
void Membership::Log(const std::string& text) {
  const std::string line = text.substr(0, text.find(" ("));
  if (line == logged_) return;
  logged_ = line;
  tendon::Log(LogLevel::kInfo, context_.name, text);
}

/// Logs a warning if it differs from the last one.
void Membership::Warn(const std::string& text) {
  if (std::exchange(warned_, text) == text || text.empty()) return;
  tendon::Log(LogLevel::kWarning, context_.name, "process '" + context_.name + "' " + text);
}

}  // namespace tendon
