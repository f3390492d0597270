#pragma once

#include <gcm_gui/graph/layout/graph_picture.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/system_requests.h>
#include <tendon/interface/compatibility.h>
#include <tendon/process/membership_messages.h>

#include <QObject>
#include <QString>
#include <QStringList>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace tendon::gui {

/// A port that may be connected to the port that the user has chosen first.
struct PortCandidate {
  PortName port;
  Compatibility compatibility;
  int number = 0;        ///< the digit key that picks it, 1 to 9; 0 for none
  bool gone = false;     ///< its process is lost, so a connection will be pending
  bool present = false;  ///< true if it is already connected to the chosen port
  /// The present peer of the required interface. The new connection would replace this peer.
  std::optional<InterfaceName> former;

  [[nodiscard]] bool fits() const { return compatibility.fits() && !present; }
  /// Returns true if some members match or have the same names, so that the user may mean this
  /// candidate although it does not fit.
  [[nodiscard]] bool looksAlike() const;
  /// Returns why this port cannot be picked, one clause per line.
  [[nodiscard]] QStringList reasons() const;
};

/// The connect mode: the user has chosen the first port of a connection, but not the second one.
/// Knows which ports fit, and why the others do not; requests the connection when a port is picked.
/// A port that is already connected can get another peer.
class ConnectMode : public QObject {
  Q_OBJECT

 public:
  /// Updates the candidates when the catalogue changes. The mode ends if the chosen port
  /// disappears, or if another user connects or disconnects it.
  ConnectMode(const CatalogueStore& store, SystemActions& actions, QObject* parent = nullptr);

  /// From now on, start() fails with this reason.
  void forbid(const QString& reason) { forbidden_ = reason; }
  [[nodiscard]] bool active() const { return chosen_.has_value(); }
  [[nodiscard]] const PortName& chosen() const { return *chosen_; }
  /// The present peer of the chosen port, if the port is a required interface.
  [[nodiscard]] const std::optional<InterfaceName>& former() const { return former_; }
  /// All candidates, best first. Candidates that do not fit come last.
  [[nodiscard]] const std::vector<PortCandidate>& candidates() const { return candidates_; }
  /// Returns the best candidate that fits; null if there is none.
  [[nodiscard]] const PortCandidate* best() const;
  [[nodiscard]] const PortCandidate* find(const PortName& port) const;
  /// Returns the candidate that is most similar to the chosen port but does not fit; null if there
  /// is none.
  [[nodiscard]] const PortCandidate* bestLookAlike() const;

 public Q_SLOTS:
  /// Starts the mode with this port. If the port does not exist or the mode is forbidden, emits a
  /// notice() and returns false.
  bool start(const tendon::gui::PortName& port);
  void leave();
  /// Requests the connection of the chosen port to `port`. If `port` does not fit, emits a notice()
  /// instead, and also mismatchPicked() if it looks alike.
  void pick(const tendon::gui::PortName& port);
  void pickNumber(int number);
  void pickBest();

 Q_SIGNALS:
  void changed();
  void picked(const tendon::InterfaceName& required, const tendon::InterfaceName& provided);
  /// Emitted when the user has picked a similar port that does not fit. No request was sent;
  /// `reason` says why the port does not fit.
  void mismatchPicked(const tendon::message::ConnectionEnds& ends, const QString& reason);
  /// Emitted with one sentence for the user.
  void notice(const QString& text);

 private:
  void follow();
  void refuse(const PortCandidate& candidate);
  /// Returns the connection between the chosen port and `port`.
  [[nodiscard]] message::ConnectionEnds endsTo(const PortName& port) const;
  void rank();
  /// Adds a candidate for each port of one side. `describe` sets whether and how it fits.
  template <typename Ports, typename Describe>
  void addCandidates(Side side, Ports ComponentDescription::*ports, Describe describe);
  void addProvided(const RequiredDescription& required);
  void addRequired(const ProvidedDescription& provided);
  [[nodiscard]] bool isThere(const PortName& port) const;
  /// Returns the present peer of a required port.
  [[nodiscard]] std::optional<InterfaceName> peerOf(const PortName& port) const;

  const CatalogueStore& store_;
  SystemActions& actions_;
  QString forbidden_;
  std::optional<PortName> chosen_;
  std::optional<InterfaceName> former_;
  std::vector<PortCandidate> candidates_;
  std::map<PortName, std::size_t> places_;  // index into candidates_
};

}  // namespace tendon::gui
