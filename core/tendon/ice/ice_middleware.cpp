#include <tendon/ice/ice_middleware.h>

#include <Ice/Ice.h>
#include <IceUtil/Timer.h>
#include <tendon/base/log.h>
#include <tendon/base/os/route.h>
#include <tendon/base/os/socket.h>
#include <tendon/base/text.h>
#include <tendon/ice/ice_broadcast.h>
#include <tendon/ice/pending_handshakes.h>
#include <tendon/ice/sequence_size_check.h>
#include <tendon/ice/servants.h>
#include <tendon/ice/settings.h>
#include <tendon/ice/tls.h>
#include <tendon/middleware/connect_cancellation.h>
#include <tendon/middleware/one_shot_value.h>

#include <cerrno>
#include <exception>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>

namespace tendon {
namespace ice {
namespace {

std::uint16_t PortOf(const Ice::ObjectAdapter& adapter) {
  for (const auto& endpoint : adapter.getEndpoints()) {
    auto info = endpoint->getInfo();
    while (info->underlying) info = info->underlying;
    const auto place = std::dynamic_pointer_cast<Ice::TCPEndpointInfo>(info);
    if (place) return static_cast<std::uint16_t>(place->port);
  }
  return 0;
}

/// Ends the waiting for deferred replies that take too long (PendingCalls::ReleaseOld()). Runs in
/// the thread of Ice's timer.
class PendingCallsTimer final : public IceUtil::TimerTask {
 public:
  explicit PendingCallsTimer(std::shared_ptr<Links> links) : links_(std::move(links)) {}
  void runTimerTask() override { links_->ReleaseOldCalls(SteadyClock().Now()); }

 private:
  const std::shared_ptr<Links> links_;
};

/// `tls` is null without TLS.
std::shared_ptr<Ice::Communicator> MakeCommunicator(const std::shared_ptr<Tls>& tls,
                                                    const std::shared_ptr<Links>& links) {
  auto settings = Settings();
  const auto pending_handshakes = std::make_shared<PendingHandshakes>(links);
  settings.observer = pending_handshakes;
  if (tls) tls->AddTo(*settings.properties);
  auto communicator = Ice::initialize(settings);
  pending_handshakes->Watch(communicator);
  IceInternal::getInstanceTimer(communicator)
      ->scheduleRepeated(std::make_shared<PendingCallsTimer>(links),
                         IceUtil::Time::milliSeconds(PendingCalls::kOpenAtMost.count()));
  if (tls) tls->CheckPeersOf(*communicator);
  return communicator;
}

Error WhyNotListening(const HostPort& place) {
  try {
    throw;
  } catch (const Ice::DNSException&) {
    return {ErrorCode::kUnreachable, "host '" + place.host + "' is unknown"};
  } catch (const Ice::SyscallException& failure) {
    if (failure.error == EADDRINUSE) return os::AddressInUse(place.host, place.port);
    return {ErrorCode::kDenied, "cannot listen at " + ToString(place) + ": " +
                                    std::generic_category().message(failure.error)};
  } catch (const Ice::Exception& failure) {
    return {ErrorCode::kDenied, "cannot listen at " + ToString(place) + ": " + failure.ice_id()};
  }
}

/// Returns the error for a link that was not opened in time. Here and in the functions below, `tls`
/// is null without TLS.
Error TimedOut(const HostPort& place, std::chrono::milliseconds timeout, const Tls* tls) {
  return {
      ErrorCode::kTimeout,
      "no reply from " + ToString(place) + " within " + Milliseconds(timeout) +
          (tls != nullptr ? ""
                          : ": the program at this address hangs, or requires a --certificate")};
}

/// Thrown when the attempt to open a link was cancelled.
struct ConnectCancellationSignal {};
std::exception_ptr NobodyWaits() { return std::make_exception_ptr(ConnectCancellationSignal()); }

Error WhyNotOpened(const std::exception_ptr& why, const HostPort& place,
                   std::chrono::milliseconds timeout, Tls* tls) {
  try {
    std::rethrow_exception(why);
  } catch (const ConnectCancellationSignal&) {
    return ConnectCancelledError();
  } catch (const Ice::DNSException&) {
    return {ErrorCode::kUnreachable, "host '" + place.host + "' is unknown"};
  } catch (const Ice::TimeoutException&) {
    return TimedOut(place, timeout, tls);
  } catch (const Ice::SecurityException& failure) {
    return tls->NotTrusted(place, failure.reason);
  } catch (const Ice::ConnectionLostException&) {
    if (tls != nullptr) return tls->NotAccepted(place);
    return {ErrorCode::kUnreachable,
            ToString(place) +
                " closed the connection immediately: check that a program of Tendon listens at "
                "this address; that program may require a --certificate"};
  } catch (const Ice::SyscallException& failure) {
    return {ErrorCode::kUnreachable, os::WhyNotReached(ToString(place), failure.error)};
  } catch (const Ice::Exception& failure) {
    if (tls != nullptr) return tls->NotAccepted(place);
    return {ErrorCode::kUnreachable,
            "no program of Tendon answers at " + ToString(place) + " (" + failure.ice_id() + ")"};
  }
}

class IceMiddleware final : public Middleware {
 public:
  /// `tls` is null without TLS.
  IceMiddleware(Exposure exposure, std::shared_ptr<Tls> tls)
      : exposure_(exposure),
        tls_(std::move(tls)),
        communicator_(MakeCommunicator(tls_, links_)),
        opened_(communicator_->createObjectAdapter("")),
        broadcast_(communicator_, tls_ != nullptr) {
    if (!RefusesImpossibleSizes(communicator_)) {
      Log(LogLevel::kWarning, "ice",
          "this build of Ice does not check the sizes in messages: any program on this machine can "
          "exhaust the memory of this program; use the Ice of Debian, or plain TCP");
    }
    opened_->add(std::make_shared<EndpointServant>(links_), EndpointIdentity());
    opened_->activate();
  }

  ~IceMiddleware() override {
    links_->CloseAll(0);
    communicator_->destroy();
  }

  [[nodiscard]] std::string_view name() const override { return "ice"; }
  [[nodiscard]] const Certificate* certificate() const override {
    return tls_ ? &tls_->certificate() : nullptr;
  }
  /// Returns null if the certificate belongs to a person. With TLS, the broker connects to each
  /// subscriber, so only the certificate of a process can be used.
  [[nodiscard]] Broadcast* broadcast() override {
    return tls_ && tls_->certificate().holder == Holder::kPerson ? nullptr : &broadcast_;
  }

  Result<std::unique_ptr<Listener>> Listen(const std::string& address, AcceptLink accept) override {
    const auto place = ParseAllowedAddress(address, 0, exposure_);
    if (!place) return place.error();
    const std::uint64_t listener = NewNumber();
    try {
      const auto adapter = MakeListeningAdapter(
          *communicator_, std::string(PendingHandshakes::kListener) + std::to_string(listener),
          EndpointAt(*place));
      const auto servant = std::make_shared<AcceptingServant>(links_, std::move(accept), listener);
      adapter->add(servant, EndpointIdentity());
      adapter->activate();
      const std::uint16_t port = PortOf(*adapter);
      os::AdoptSocket(port, 0);
      WarnOfExposure(exposure_, "ice");
      return MakeListener(ToString(HostPort{place->host, port}), [adapter, servant] {
        servant->Stop();
        adapter->destroy();
      });
    } catch (const Ice::Exception&) {
      return WhyNotListening(*place);
    }
  }

  Result<std::shared_ptr<Link>> Open(const std::string& address,
                                     std::shared_ptr<LinkHandler> handler,
                                     std::chrono::milliseconds timeout) override {
    const SteadyTime deadline = SteadyClock().Now() + timeout;
    const auto place = ParseAllowedAddress(address, 1, exposure_);
    if (!place) return place.error();
    auto connection = Connect(*place, deadline);
    if (!connection) return TimedOut(*place, timeout, tls_.get());
    if (connection->why) return WhyNotOpened(connection->why, *place, timeout, tls_.get());
    AdoptSocket(*connection->connection);
    std::shared_ptr<IceLink> link;
    try {
      link = std::make_shared<IceLink>(connection->connection, 0);
    } catch (const Ice::Exception&) {
      connection->connection->close(Ice::ConnectionClose::Forcefully);
      return WhyNotOpened(std::current_exception(), *place, timeout, tls_.get());
    }
    link->SetHandler(std::move(handler));
    const auto refused = Greet(link, connection->connection, deadline);
    if (refused && !*refused) return std::shared_ptr<Link>(std::move(link));
    link->SetHandler(nullptr);
    link->CloseAtOnce();
    return refused ? WhyNotOpened(*refused, *place, timeout, tls_.get())
                   : TimedOut(*place, timeout, tls_.get());
  }

 private:
  struct Connected {
    std::shared_ptr<Ice::Connection> connection;
    std::exception_ptr why;
  };

  [[nodiscard]] std::string EndpointAt(const HostPort& place) const {
    return (tls_ ? "ssl -h \"" : "tcp -h \"") + place.host + "\" -p " + std::to_string(place.port);
  }

  std::uint64_t NewNumber() {
    const std::scoped_lock lock(mutex_);
    return ++last_number_;
  }

  /// Returns a new connection, or the reason why there is no connection. Returns no value if
  /// `deadline` passes first.
  std::optional<Connected> Connect(const HostPort& place, SteadyTime deadline) {
    const auto proxy =
        communicator_->stringToProxy("tendon:" + EndpointAt(place))
            ->ice_connectionId(std::to_string(NewNumber()));  // a new connection for each link
    const auto connected = std::make_shared<OneShotValue<Connected>>();
    try {
      proxy->ice_getConnectionAsync(
          [connected](const std::shared_ptr<Ice::Connection>& connection) {
            const bool wanted = connected->Give({connection, nullptr});
            if (!wanted) connection->close(Ice::ConnectionClose::Forcefully);
          },
          [connected](const std::exception_ptr& why) {
            connected->Give({nullptr, why});
          });
    } catch (const Ice::Exception&) {
      connected->Give({nullptr, std::current_exception()});
    }
    const CancellableConnect wait([&connected] { connected->Give({nullptr, NobodyWaits()}); });
    return connected->WaitUntil(deadline);
  }

  /// Begins to serve a link, and sends a ping so that the other end also begins to serve it.
  /// Returns the failure (null: success), or no value if `deadline` passes first.
  std::optional<std::exception_ptr> Greet(const std::shared_ptr<IceLink>& link,
                                          const std::shared_ptr<Ice::Connection>& connection,
                                          SteadyTime deadline) {
    const auto answered = std::make_shared<OneShotValue<std::exception_ptr>>();
    const auto give = [answered](const std::exception_ptr& why) { answered->Give(why); };
    try {
      connection->setAdapter(opened_);
      Links::Add(links_, link);
      connection->createProxy(EndpointIdentity())
          ->ice_invokeAsync(
              "ice_ping", Ice::OperationMode::Normal, std::vector<Ice::Byte>(),
              [give](bool /*ok*/, const std::vector<Ice::Byte>& /*reply*/) { give(nullptr); },
              give);
    } catch (const Ice::Exception&) {
      give(std::current_exception());
    }
    const CancellableConnect wait([&answered] { answered->Give(NobodyWaits()); });
    return answered->WaitUntil(deadline);
  }

  const Exposure exposure_;
  const std::shared_ptr<Tls> tls_;
  const std::shared_ptr<Links> links_ = std::make_shared<Links>();
  const std::shared_ptr<Ice::Communicator> communicator_;
  // Serves the connections that this process opens.
  const std::shared_ptr<Ice::ObjectAdapter> opened_;
  IceBroadcast broadcast_;
  std::mutex mutex_;
  std::uint64_t last_number_ = 0;
};

}  // namespace
}  // namespace ice

std::string IceVersion() { return ICE_STRING_VERSION; }

std::unique_ptr<Middleware> MakeIceMiddleware(Exposure exposure) {
  return std::make_unique<ice::IceMiddleware>(exposure, nullptr);
}

Result<std::unique_ptr<Middleware>> MakeIceMiddleware(const Credentials& credentials) {
  auto tls = ice::Tls::Make(credentials);
  if (!tls) return tls.error();
  try {
    return std::unique_ptr<Middleware>(
        std::make_unique<ice::IceMiddleware>(Exposure::kCertified, *std::move(tls)));
  } catch (const Ice::Exception& failure) {  // Ice reads the same files, and may reject them
    return Error{
        ErrorCode::kInvalid,
        "TLS cannot be started with " + credentials.certificate.string() + ": " + failure.ice_id()};
  }
}

}  // namespace tendon
