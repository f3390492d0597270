#pragma once

#include <gcm_gui/diagnosis/refused_connections.h>
#include <tendon/gcm/diagnosis.h>

#include <QString>
#include <QStringList>
#include <optional>
#include <string>

namespace tendon::gui {

/// The contents of the Why? card for one connection.
struct DiagnosisReport {
  Diagnosis diagnosis;
  std::optional<RefusedConnection> refusal;  ///< the last refusal of this connection
  QStringList leftovers;                     ///< the LeftoverTexts() of a connection attempt

  /// The result in a few words: "fails at step 5 of 7", "connected and working", "nothing prevents
  /// the connection".
  [[nodiscard]] QString verdict() const;
  /// The last refusal: "refused at 12:04:31: no reply from desk"; empty if there is none.
  [[nodiscard]] QString history() const;
  /// The shell command that prints the same report.
  [[nodiscard]] QString command() const;
  /// The whole report as text for an e-mail. The steps have the same numbers and texts as in `gcm
  /// explain`.
  [[nodiscard]] QString text() const;
};

/// Returns the provided interface that the user probably means when he asks why `required` is not
/// connected: the provider whose connection was refused, otherwise the connected provider,
/// otherwise the best candidate.
[[nodiscard]] std::optional<InterfaceName> LikelyProvider(const Catalogue& catalogue,
                                                          const RefusedConnections& refusals,
                                                          const InterfaceName& required);

/// Returns the part of a remedy that is worth copying: its command, or the whole text if it
/// contains no command.
[[nodiscard]] QString CommandOfFix(const std::string& fix);

}  // namespace tendon::gui
