#include <tendon/ice/settings.h>

#include <tendon/base/log.h>
#include <tendon/base/rate_limited_warning.h>
#include <tendon/middleware/part_sender.h>
#include <tendon/process/audit_log.h>

#include <string>
#include <string_view>

namespace tendon::ice {
namespace {

/// Returns the text after `title` in a message of Ice, up to the end of the line.
std::string After(std::string_view title, const std::string& message) {
  const auto found = message.find(title);
  if (found == message.npos) return "an unknown peer";
  const auto begin = found + title.size();
  return message.substr(begin, message.find('\n', begin) - begin);
}

class Logger final : public Ice::Logger, public std::enable_shared_from_this<Logger> {
 public:
  void print(const std::string& message) override {
    Log(LogLevel::kInfo, "ice", OnOneLine(message));
  }
  void trace(const std::string& category, const std::string& message) override {
    // If OpenSSL rejects a certificate, Ice reports this only in its log.
    if (category == "Security" && message.starts_with("certificate verification failure")) {
      const std::string place = After("remote address = ", message);
      const std::string address = place.substr(0, place.rfind(':'));
      const std::string line = address + " was refused: " + OnOneLine(message);
      return audit_.Write(address, LogLevel::kWarning, line);
    }
    Log(LogLevel::kDebug, "ice", category + ": " + OnOneLine(message));
  }
  void warning(const std::string& message) override { warnings_.Add(OnOneLine(message)); }
  void error(const std::string& message) override {
    Log(LogLevel::kError, "ice", OnOneLine(message));
  }
  std::string getPrefix() override { return {}; }
  std::shared_ptr<Ice::Logger> cloneWithPrefix(const std::string& /*prefix*/) override {
    return shared_from_this();
  }

 private:
  RateLimitedWarning warnings_{"ice"};
  AuditLog audit_;
};

/// Returns the size limit in KiB for a message of Ice that contains a frame of this size.
std::string KibibytesFor(std::size_t frame) {
  constexpr std::size_t kKibi = 1024;
  constexpr std::size_t kEnvelope = 16;  // KiB for Ice's envelope
  return std::to_string(frame / kKibi + kEnvelope);
}

}  // namespace

std::string OnOneLine(const std::string& text) {
  std::string line;
  for (const char c : text) {
    if (c != '\n') {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  return line;
}

Ice::InitializationData Settings() {
  Ice::InitializationData settings;
  settings.logger = std::make_shared<Logger>();
  settings.properties = Ice::createProperties();
  const auto set = [&](const char* name, const std::string& value) {
    settings.properties->setProperty(name, value);
  };
  set("Ice.Admin.Enabled", "0");
  set("Ice.MessageSizeMax", KibibytesFor(kMaxReturned));
  set("Ice.RetryIntervals", "-1");
  set("Ice.Default.CollocationOptimized", "0");
  // A connection counts as lost if no data can be sent on it for this time (ms).
  set("Ice.Override.Timeout", "3000");
  set("Ice.Override.ConnectTimeout", "3000");
  set("Ice.Override.CloseTimeout", "750");
  // Clients send heartbeats, and servers close a silent connection 2 to 4 s after its peer has
  // disappeared. Servers do not send heartbeats, because an end that sends heartbeats does not
  // notice that it receives nothing. Therefore, the opener must ping the peer, as MonitorPeer()
  // does.
  set("Ice.ACM.Timeout", "1");
  set("Ice.ACM.Client.Heartbeat", "3");  // always
  set("Ice.ACM.Client.Close", "0");
  set("Ice.ACM.Server.Heartbeat", "0");
  set("Ice.ACM.Server.Close", "1");  // when idle, but not while a call is open; see PendingCalls
  // One thread serves all opened connections, and one thread serves all accepted connections. One
  // thread also keeps the order of frames on each connection. If the pool could grow, Ice would
  // wake another thread for each message, only to wait for the next message; this costs 4 futex and
  // 2 epoll calls. More threads are not needed, because WorkerPool executes long calls.
  set("Ice.ThreadPool.Server.Size", "1");
  set("Ice.ThreadPool.Server.SizeMax", "1");
  set("Ice.ThreadPool.Client.Size", "1");
  set("Ice.ThreadPool.Client.SizeMax", "1");
  return settings;
}

std::shared_ptr<Ice::ObjectAdapter> MakeListeningAdapter(Ice::Communicator& communicator,
                                                         const std::string& name,
                                                         const std::string& endpoints) {
  communicator.getProperties()->setProperty(name + ".MessageSizeMax", KibibytesFor(kMaxPieceSize));
  return communicator.createObjectAdapterWithEndpoints(name, endpoints);
}

}  // namespace tendon::ice
