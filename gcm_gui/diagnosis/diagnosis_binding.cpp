#include <gcm_gui/diagnosis/diagnosis_binding.h>

#include <gcm_gui/diagnosis/diagnosis_card.h>
#include <gcm_gui/diagnosis/diagnosis_report.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/session/system_requests.h>
#include <tendon/base/path.h>

#include <QPointer>
#include <algorithm>
#include <utility>

namespace tendon::gui {
namespace {

std::optional<InterfaceName> RequiredOf(const Catalogue& catalogue, const QString& path) {
  const auto name = ParseInterfaceName(path.section('.', 0, 0).toStdString());
  if (!name.ok() || catalogue.FindRequired(*name) == nullptr) return std::nullopt;
  return *name;
}

}  // namespace

DiagnosisBinding::DiagnosisBinding(DiagnosisCard& card, const CatalogueStore& store,
                                   ConnectionChecks& checks, SystemActions& actions,
                                   QObject* parent)
    : QObject(parent), card_(card), store_(store), checks_(checks), actions_(actions) {
  connect(&store, &CatalogueStore::changed, this, Guarded(this, &DiagnosisBinding::follow));
  connect(&store, &CatalogueStore::typesLearned, this, Guarded(this, &DiagnosisBinding::check));
  connect(&refusals_, &RefusedConnections::changed, this, &DiagnosisBinding::check);
  connect(&card, &DiagnosisCard::closed, this, [this] { ends_.reset(); });
  connect(&card, &DiagnosisCard::retryRequested, this, &DiagnosisBinding::retry);
  connect(&card, &DiagnosisCard::notice, this, &DiagnosisBinding::notice);
}

void DiagnosisBinding::open(const QString& path) {
  const Catalogue& catalogue = store_.catalogue();
  const auto required = RequiredOf(catalogue, path);
  if (!required) {
    Q_EMIT notice(Words::tr("Select a required interface to see why it is connected or not"));
    return;
  }
  const auto provided = LikelyProvider(catalogue, refusals_, *required);
  if (!provided) {
    Q_EMIT notice(ToQString(ToString(*required)) +
                  Words::tr(" is not connected, and no available interface resembles it"));
    return;
  }
  ends_ = message::ConnectionEnds{*required, *provided};
  card_.begin(*ends_);
  check();
}

bool DiagnosisBinding::openProblem(const QString& path) {
  const auto required = RequiredOf(store_.catalogue(), path);
  if (!required) return false;
  const auto* connection = store_.catalogue().FindConnection(*required);
  const bool stands = connection != nullptr && connection->state != ConnectionState::kActive;
  if (!stands && refusals_.find(*required) == nullptr) return false;
  open(path);
  return true;
}

void DiagnosisBinding::check() {
  if (!ends_) return;
  ask_again_ = is_asking_;
  if (std::exchange(is_asking_, true)) return;
  checks_.diagnose(*ends_, [self = QPointer(this), ends = *ends_](const auto& diagnosis) {
    if (self != nullptr) self->onDiagnosis(ends, diagnosis);
  });
}

void DiagnosisBinding::onDiagnosis(const message::ConnectionEnds& ends,
                                   const Result<Diagnosis>& diagnosis) {
  is_asking_ = false;
  if (ends_ == ends) show(ends, diagnosis);
  if (ends_ != ends || std::exchange(ask_again_, false)) check();
}

void DiagnosisBinding::show(const message::ConnectionEnds& ends,
                            const Result<Diagnosis>& diagnosis) {
  if (!diagnosis) return card_.showMessage(ToQString(diagnosis.error().message));
  DiagnosisReport report{*diagnosis, std::nullopt, {}};
  const auto* refused = refusals_.find(ends.required);
  if (refused != nullptr && refused->provided == ends.provided) report.refusal = *refused;
  const Catalogue& catalogue = store_.catalogue();
  const bool is_tried = report.refusal || diagnosis->is_connected;
  if (is_tried && diagnosis->failure) {
    for (const auto& line : LeftoverTexts(*diagnosis)) report.leftovers.append(ToQString(line));
  }
  card_.show(report, catalogue.FindRequired(ends.required), catalogue.FindProvided(ends.provided));
}

void DiagnosisBinding::retry() {
  if (ends_) actions_.connectOrReplace(ends_->required, ends_->provided);
}

void DiagnosisBinding::follow(const Catalogue& catalogue, const ChangedParts& touched) {
  refusals_.update(catalogue);
  if (!ends_) return;
  const auto is_about_it = [this](const ChangedPart& part) {
    return part.process == ends_->required.process || part.process == ends_->provided.process;
  };
  if (std::ranges::any_of(touched, is_about_it)) check();
}

}  // namespace tendon::gui
