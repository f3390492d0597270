#pragma once

#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/why/refusals.h>
#include <tendon/gcm/diagnosis.h>

#include <QObject>
#include <QString>
#include <optional>

namespace tendon::gui {

class ConnectionChecks;
class SystemActions;
class WhyCard;

/// Brings the Why? card what it shows: asks anew while it is open and one of the two processes
/// changes. Never waits.
class WhyBinding : public QObject {
  Q_OBJECT

 public:
  WhyBinding(WhyCard& card, const CatalogueStore& store, ConnectionChecks& checks,
             SystemActions& actions, QObject* parent = nullptr);

  [[nodiscard]] Refusals& refusals() { return refusals_; }

 public Q_SLOTS:
  /// Of the required interface `path`; of the one that a member belongs to. Nothing but a notice()
  /// when it is none.
  void open(const QString& path);
  /// Only where something is wrong with it; says whether.
  bool openProblem(const QString& path);

 Q_SIGNALS:
  void notice(const QString& text);

 private:
  void check();
  void hear(const message::Wire& wire, const Result<Diagnosis>& diagnosis);
  void show(const message::Wire& wire, const Result<Diagnosis>& diagnosis);
  void retry();
  void follow(const Catalog& catalogue, const Touched& touched);

  WhyCard& card_;
  const CatalogueStore& store_;
  ConnectionChecks& checks_;
  SystemActions& actions_;
  Refusals refusals_;
  std::optional<message::Wire> wire_;  // of the card, while it is open
  bool is_asking_ = false;
  bool ask_again_ = false;  // something changed meanwhile
};

}  // namespace tendon::gui
