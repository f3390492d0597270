#pragma once

#include <gcm_gui/diagnosis/refused_connections.h>
#include <gcm_gui/session/catalogue_store.h>
#include <tendon/gcm/diagnosis.h>

#include <QObject>
#include <QString>
#include <optional>

namespace tendon::gui {

class ConnectionChecks;
class DiagnosisCard;
class SystemActions;

/// Fills the Why? card. Repeats the checks if one of the two processes changes while the card is
/// open. Never blocks.
class DiagnosisBinding : public QObject {
  Q_OBJECT

 public:
  DiagnosisBinding(DiagnosisCard& card, const CatalogueStore& store, ConnectionChecks& checks,
                   SystemActions& actions, QObject* parent = nullptr);

  [[nodiscard]] RefusedConnections& refusals() { return refusals_; }

 public Q_SLOTS:
  /// Opens the card for the required interface `path`, or for the required interface that contains
  /// the member `path`. For any other path, only emits a notice().
  void open(const QString& path);
  /// Opens the card only if the connection has a problem; returns true if the card was opened.
  bool openProblem(const QString& path);

 Q_SIGNALS:
  void notice(const QString& text);

 private:
  void check();
  void onDiagnosis(const message::ConnectionEnds& ends, const Result<Diagnosis>& diagnosis);
  void show(const message::ConnectionEnds& ends, const Result<Diagnosis>& diagnosis);
  void retry();
  void follow(const Catalogue& catalogue, const ChangedParts& touched);

  DiagnosisCard& card_;
  const CatalogueStore& store_;
  ConnectionChecks& checks_;
  SystemActions& actions_;
  RefusedConnections refusals_;
  std::optional<message::ConnectionEnds> ends_;  // of the open card
  bool is_asking_ = false;
  bool ask_again_ = false;  // a process has changed during the check
};

}  // namespace tendon::gui
