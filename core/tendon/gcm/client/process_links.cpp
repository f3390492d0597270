#include <tendon/gcm/client/process_links.h>

#include <tendon/base/os/process.h>
#include <tendon/process/guarded_handler.h>

#include <cstddef>
#include <span>
#include <utility>

namespace tendon::client {

class ProcessLinks::Handler final : public ChannelHandler {
 public:
  Handler(std::weak_ptr<ProcessLinks> links, std::weak_ptr<ChannelHandler> listener, Role role)
      : links_(std::move(links)), listener_(std::move(listener)), role_(role) {}

  void OnOpen(const SharedChannel& channel, const Hello& /*peer*/) override {
    LowerRole(*channel, role_);
  }

  void OnNotice(const SharedChannel& channel, const FrameHeader& header,
                std::span<const std::byte> body) override {
    if (const auto listener = listener_.lock()) listener->OnNotice(channel, header, body);
  }

  void OnClosed(const SharedChannel& channel, const Error& reason) override {
    if (const auto links = links_.lock()) links->OnChannelClosed(channel.get());
    if (const auto listener = listener_.lock()) listener->OnClosed(channel, reason);
  }

 private:
  const std::weak_ptr<ProcessLinks> links_;
  const std::weak_ptr<ChannelHandler> listener_;
  const Role role_;
};

ProcessLinks::ProcessLinks(Middleware& middleware, Resolve resolve, Options options)
    : middleware_(middleware), resolve_(std::move(resolve)), options_(std::move(options)) {}

void ProcessLinks::WithChannel(const std::string& process, Use use) {
  std::unique_lock lock(mutex_);
  if (stopped_) return;
  ProcessLink& link = links_[process];
  if (link.channel && link.channel->is_open()) {
    const SharedChannel channel = link.channel;
    lock.unlock();
    return use(channel);
  }
  link.channel.reset();
  link.waiting.push_back(std::move(use));
  if (link.waiting.size() == 1) opener_.Post([this, process] { Open(process); });
}

void ProcessLinks::Drop(const std::string& process, std::uint64_t instance) {
  std::unique_lock lock(mutex_);
  const auto found = links_.find(process);
  if (found == links_.end() || !found->second.channel) return;
  // This program may already have connected to the new instance. Then requests may be pending on
  // the channel, so it stays open.
  if (found->second.channel->peer().instance == instance) return;
  const SharedChannel channel = std::exchange(found->second.channel, nullptr);
  lock.unlock();
  channel->Close();
}

void ProcessLinks::Stop() {
  std::map<std::string, ProcessLink> links;
  {
    const std::scoped_lock lock(mutex_);
    stopped_ = true;
    links.swap(links_);
  }
  for (const auto& [process, link] : links) {
    if (link.channel) link.channel->Close();
  }
  opener_.Stop();
}

/// Opens a channel and passes it to the waiting requests. Called in the opener's thread.
void ProcessLinks::Open(const std::string& process) {
  const auto channel = TryOpen(process);
  std::vector<Use> waiting;
  {
    const std::scoped_lock lock(mutex_);
    if (stopped_) {
      if (channel) (*channel)->Close();
      return;
    }
    ProcessLink& link = links_[process];
    waiting.swap(link.waiting);
    if (channel) link.channel = *channel;
  }
  for (const Use& use : waiting) use(channel);
}

Result<ProcessLinks::SharedChannel> ProcessLinks::TryOpen(const std::string& process) {
  const auto there = resolve_(process);
  if (!there) return there.error();
  const auto cookie = LoopbackCookie();
  if (!cookie) return cookie.error();
  const Hello mine{
      .instance = os::RandomNumber(), .name = options_.name, .wanted = process, .cookie = *cookie};
  const auto handler = std::make_shared<Handler>(weak_from_this(), listener_, options_.role);
  const std::string who = "process '" + process + "' does not answer at " + there->address;
  auto channel = Channel::Open(middleware_, there->address, mine, handler, options_.timeout);
  if (!channel) return Error{channel.error().code, who + ": " + channel.error().message};
  if ((*channel)->peer().instance == there->instance) return channel;
  (*channel)->Close();
  return Error{ErrorCode::kUnreachable, who + ": another program listens at this address"};
}

void ProcessLinks::OnChannelClosed(const Channel* channel) {
  const std::scoped_lock lock(mutex_);
  for (auto& [process, link] : links_) {
    if (link.channel.get() == channel) link.channel.reset();
  }
}

}  // namespace tendon::client
