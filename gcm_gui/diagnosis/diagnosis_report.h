#pragma once

#include <gcm_gui/diagnosis/refused_connections.h>
#include <tendon/gcm/diagnosis.h>

#include <QString>
#include <QStringList>
#include <optional>

namespace tendon::gui {

/// The contents of the Why? card for one connection.
struct DiagnosisReport {
  Diagnosis diagnosis;
  std::optional<RefusedConnection> refusal;  ///< the last refusal of this connection
  QStringList leftovers;                     ///< LeftoverTexts() of a connection that was tried

  /// "fails at step 5 of 7", "connected and working", "nothing prevents the connection".
  [[nodiscard]] QString verdict() const;
  /// "refused at 12:04:31: no answer from desk", or empty.
  [[nodiscard]] QString history() const;
  /// The shell command that gives the same report.
  [[nodiscard]] QString command() const;
  /// The whole report as text for a mail; numbers and texts of the steps are those of `gcm
  /// explain`.
  [[nodiscard]] QString text() const;
};

/// The provided interface that the user probably means when asking why `required` is not connected:
/// the refused one, otherwise the connected one, otherwise the best candidate.
[[nodiscard]] std::optional<InterfaceName> LikelyProvider(const Catalogue& catalogue,
                                                          const RefusedConnections& refusals,
                                                          const InterfaceName& required);

/// The part of a remedy to copy: its command if there is one, otherwise the whole text.
[[nodiscard]] QString CommandOfFix(const std::string& fix);

}  // namespace tendon::gui
