#pragma once

#include <gcm_gui/why/refusals.h>
#include <tendon/gcm/diagnosis.h>

#include <QString>
#include <QStringList>
#include <optional>

namespace tendon::gui {

/// All that the Why? card says of a connection.
struct WhyReport {
  Diagnosis diagnosis;
  std::optional<RefusedConnection> refusal;  ///< the last one, of this very connection
  QStringList leftovers;                     ///< as LeftoverTexts(), of one that was tried

  /// "fails at step 5 of 7", "connected and working", "nothing keeps it from being connected".
  [[nodiscard]] QString verdict() const;
  /// "refused at 12:04:31: no answer from desk", or empty.
  [[nodiscard]] QString history() const;
  /// The line that says the same in a terminal.
  [[nodiscard]] QString command() const;
  /// All of it for a mail: the steps are numbered and worded as `gcm explain` prints them.
  [[nodiscard]] QString text() const;
};

/// The provided interface that a user means who asks why `required` is not connected: the one that
/// was refused, else the one it is connected to, else the best candidate.
[[nodiscard]] std::optional<InterfaceName> LikelyProvider(const Catalog& catalogue,
                                                          const Refusals& refusals,
                                                          const InterfaceName& required);

/// What of a fix can be copied: its command if it names one, else all of it.
[[nodiscard]] QString CommandOfFix(const std::string& fix);

}  // namespace tendon::gui
