#include <tendon/ice/broker_connection.h>

#include <tendon/base/os/socket.h>
#include <tendon/ice/broker.h>
#include <tendon/ice/connection_socket.h>
#include <tendon/ice/tls.h>
#include <tendon/middleware/middleware.h>

namespace tendon::ice {

Result<std::shared_ptr<IceStorm::TopicManagerPrx>> BrokerConnection::Open(
    const std::string& broker) const {
  const auto place = ParseAllowedAddress(
      broker, 1, is_certified_ ? Exposure::kCertified : Exposure::kLoopbackOnly);
  if (!place) return place.error();
  const auto instance = BrokerInstance(is_certified_);
  if (!instance) return instance.error();
  const auto manager = Reach(communicator_->stringToProxy(
      *instance + "/TopicManager:" + (is_certified_ ? "ssl" : "tcp") + " -h \"" + place->host +
      "\" -p " + std::to_string(place->port)));
  if (!manager) return manager.error();
  return Ice::uncheckedCast<IceStorm::TopicManagerPrx>(*manager);
}

Result<std::shared_ptr<Ice::ObjectPrx>> BrokerConnection::Reach(
    const std::shared_ptr<Ice::ObjectPrx>& object) const {
  constexpr int kLongest = 3000;  // ms to wait for a reply
  const auto connection = object->ice_connectionId("broker")->ice_getConnection();
  if (auto good = CheckPeer(*connection); !good) return good.error();
  AdoptSocket(*connection);
  return connection->createProxy(object->ice_getIdentity())->ice_invocationTimeout(kLongest);
}

Result<void> BrokerConnection::CheckPeer(const Ice::Connection& connection) const {
  if (const auto certificate = CertificateOf(connection)) {
    if (certificate->name == kBrokerName) return {};
    return Error{ErrorCode::kDenied, "the broker has the certificate of '" + certificate->name +
                                         "', but needs that of '" + kBrokerName + "'"};
  }
  const auto info = std::dynamic_pointer_cast<Ice::IPConnectionInfo>(connection.getInfo());
  if (info && os::IsHeldByUser(static_cast<std::uint16_t>(info->remotePort))) return {};
  return Error{ErrorCode::kDenied, "the broker is not a program of this user"};
}

}  // namespace tendon::ice
