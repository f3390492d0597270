#pragma once

#include <gcm_gui/graph/layout/graph_picture.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/system_actions.h>
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

/// A port that the chosen one might be connected to.
struct Candidate {
  PortName port;
  Compatibility compatibility;
  int number = 0;        ///< the digit that picks it, 1 to 9; 0 for none
  bool gone = false;     ///< its process is lost; connecting waits for its return
  bool present = false;  ///< it is what the chosen one is connected to now
  /// Of a required interface that is connected elsewhere: what it would be taken from.
  std::optional<InterfaceName> former;

  [[nodiscard]] bool fits() const { return compatibility.fits() && !present; }
  /// Not by chance: some of its members are what is needed, or are meant to be.
  [[nodiscard]] bool looksAlike() const;
  /// Why it cannot be picked, one clause a line.
  [[nodiscard]] QStringList reasons() const;
};

/// The moment between choosing one end of a connection and the other. Knows which ports fit and why
/// the others do not; asks for the connection when one is picked. What is connected already can be
/// connected to another.
class ConnectMode : public QObject {
  Q_OBJECT

 public:
  /// The candidates follow the catalogue; when the chosen port goes, or is connected or
  /// disconnected by somebody else, the mode ends.
  ConnectMode(const CatalogueStore& store, SystemActions& actions, QObject* parent = nullptr);

  /// From now on nothing is begun, and this is why.
  void forbid(const QString& reason) { forbidden_ = reason; }
  [[nodiscard]] bool active() const { return chosen_.has_value(); }
  [[nodiscard]] const PortName& chosen() const { return *chosen_; }
  /// The chosen one is required, and this is what it is connected to.
  [[nodiscard]] const std::optional<InterfaceName>& former() const { return former_; }
  /// Best first, those that do not fit last.
  [[nodiscard]] const std::vector<Candidate>& candidates() const { return candidates_; }
  /// Null while nothing fits, and for a port that is no candidate.
  [[nodiscard]] const Candidate* best() const;
  [[nodiscard]] const Candidate* find(const PortName& port) const;
  /// The one that most resembles what is needed and does not fit, or null.
  [[nodiscard]] const Candidate* bestLookAlike() const;

 public Q_SLOTS:
  /// False when there is no such port, or when it is forbidden, which a notice() tells.
  bool start(const tendon::gui::PortName& port);
  void leave();
  /// Connects; when it does not fit, nothing happens but a notice(), and misfitPicked() where it
  /// was not by chance.
  void pick(const tendon::gui::PortName& port);
  void pickNumber(int number);
  void pickBest();

 Q_SIGNALS:
  void changed();
  void picked(const tendon::InterfaceName& required, const tendon::InterfaceName& provided);
  /// One that looks alike was wanted; nobody was asked for it, and this is why.
  void misfitPicked(const tendon::message::Wire& wire, const QString& reason);
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  void follow();
  void refuse(const Candidate& candidate);
  /// Between the chosen port and this one.
  [[nodiscard]] message::Wire wireTo(const PortName& port) const;
  void rank();
  void addProvided(const RequiredDescription& required);
  void addRequired(const ProvidedDescription& provided);
  [[nodiscard]] bool isThere(const PortName& port) const;
  /// What a required port is connected to.
  [[nodiscard]] std::optional<InterfaceName> peerOf(const PortName& port) const;

  const CatalogueStore& store_;
  SystemActions& actions_;
  QString forbidden_;
  std::optional<PortName> chosen_;
  std::optional<InterfaceName> former_;
  std::vector<Candidate> candidates_;
  std::map<PortName, std::size_t> places_;  // of the candidates
};

}  // namespace tendon::gui
