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

/// A port that may be connected to the chosen one.
struct PortCandidate {
  PortName port;
  Compatibility compatibility;
  int number = 0;        ///< the digit that picks it, 1 to 9; 0 for none
  bool gone = false;     ///< its process is lost; a connection will be pending
  bool present = false;  ///< the present peer of the chosen port
  /// The present peer of the required interface, which it would lose.
  std::optional<InterfaceName> former;

  [[nodiscard]] bool fits() const { return compatibility.fits() && !present; }
  /// True if some members match, or have the same names, so that the user may mean this candidate.
  [[nodiscard]] bool looksAlike() const;
  /// The reasons why it cannot be picked, one clause per line.
  [[nodiscard]] QStringList reasons() const;
};

/// The state between choosing the first and the second end of a connection. Has the ports that fit
/// and the reasons why the others do not; requests the connection when a port is picked. A
/// connected port can be connected to another peer.
class ConnectMode : public QObject {
  Q_OBJECT

 public:
  /// The candidates follow the catalogue. The mode ends when the chosen port disappears, or another
  /// user connects or disconnects it.
  ConnectMode(const CatalogueStore& store, SystemActions& actions, QObject* parent = nullptr);

  /// start() fails from now on, with this reason.
  void forbid(const QString& reason) { forbidden_ = reason; }
  [[nodiscard]] bool active() const { return chosen_.has_value(); }
  [[nodiscard]] const PortName& chosen() const { return *chosen_; }
  /// The present peer of the chosen port, if the port is a required interface.
  [[nodiscard]] const std::optional<InterfaceName>& former() const { return former_; }
  /// Best first; those that do not fit come last.
  [[nodiscard]] const std::vector<PortCandidate>& candidates() const { return candidates_; }
  /// Null if nothing fits.
  [[nodiscard]] const PortCandidate* best() const;
  [[nodiscard]] const PortCandidate* find(const PortName& port) const;
  /// The most similar candidate that does not fit, or null.
  [[nodiscard]] const PortCandidate* bestLookAlike() const;

 public Q_SLOTS:
  /// Returns false if the port does not exist, or if the mode is forbidden; then emits a notice().
  bool start(const tendon::gui::PortName& port);
  void leave();
  /// Requests the connection. If the port does not fit, only emits a notice(), and mismatchPicked()
  /// if it looks alike.
  void pick(const tendon::gui::PortName& port);
  void pickNumber(int number);
  void pickBest();

 Q_SIGNALS:
  void changed();
  void picked(const tendon::InterfaceName& required, const tendon::InterfaceName& provided);
  /// The user picked a similar port that does not fit. No request was sent; `reason` says why the
  /// port does not fit.
  void mismatchPicked(const tendon::message::Wire& wire, const QString& reason);
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  void follow();
  void refuse(const PortCandidate& candidate);
  /// The connection between the chosen port and `port`.
  [[nodiscard]] message::Wire wireTo(const PortName& port) const;
  void rank();
  void addProvided(const RequiredDescription& required);
  void addRequired(const ProvidedDescription& provided);
  [[nodiscard]] bool isThere(const PortName& port) const;
  /// The present peer of a required port.
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
