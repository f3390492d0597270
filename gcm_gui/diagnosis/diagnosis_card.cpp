#include <gcm_gui/diagnosis/diagnosis_card.h>

#include <gcm_gui/diagnosis/step_list.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/header_row.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace tendon::gui {
namespace {

QString ShortInterfaceName(const InterfaceName& name) {
  return ToQString(name.component + '/' + name.interface);
}

}  // namespace

DiagnosisCard::DiagnosisCard(QWidget& place)
    : OverlayCard(place, new QWidget),
      title_(new QLabel),
      verdict_(MakeTextLine(QStringLiteral("why.verdict"), QStringLiteral("strong"))),
      history_(MakeTextLine(QStringLiteral("why.history"), QStringLiteral("dim"))),
      steps_(new StepList(signatures_)),
      leftovers_(MakeTextLine(QStringLiteral("why.leftovers"), {})),
      retry_(new QPushButton(Words::tr("Retry"))),
      copy_(new QPushButton(Words::tr("Copy report"))) {
  setObjectName(QStringLiteral("whyCard"));
  setAccessibleName(Words::tr("Why?"));
  buildBody(body());
  buildHead();
  connect(steps_, &StepList::copied, this, &DiagnosisCard::notice);
}

void DiagnosisCard::buildBody(QWidget& body) {
  auto* lines = new QVBoxLayout(&body);
  lines->setContentsMargins(kInset, 2 * kGrid, kInset, 2 * kGrid);
  lines->setSpacing(2 * kGrid);
  lines->addWidget(verdict_);
  lines->addWidget(history_);
  lines->addWidget(steps_);
  lines->addWidget(leftovers_);
  lines->addStretch();
}

void DiagnosisCard::buildHead() {
  title_->setObjectName(QStringLiteral("why.title"));
  SetRole(*title_, QStringLiteral("strong"));
  retry_->setObjectName(QStringLiteral("why.retry"));
  retry_->setProperty("changesSystem", true);
  copy_->setObjectName(QStringLiteral("why.copyReport"));
  copy_->setAccessibleName(Words::tr("Copy the report"));
  connect(retry_, &QPushButton::clicked, this, &DiagnosisCard::retryRequested);
  connect(copy_, &QPushButton::clicked, this, &DiagnosisCard::copyReport);
  head().addLeft(title_);
  addToHead(retry_);
  addToHead(copy_);
}

void DiagnosisCard::begin(const message::ConnectionEnds& ends) {
  const bool other = ends != report_.diagnosis.ends;
  report_.diagnosis.ends = ends;
  title_->setText(ShortInterfaceName(ends.required) + QStringLiteral(" → ") +
                  ShortInterfaceName(ends.provided));
  title_->setToolTip(ToQString(ToString(ends.required) + " → " + ToString(ends.provided)));
  setAccessibleName(Words::tr("Why? ") + title_->toolTip());
  if (other || isHidden()) {
    showMessage(Words::tr("checking …"));
    steps_->setComparable(false);
    steps_->show({});
  }
  open();
}

void DiagnosisCard::show(const DiagnosisReport& report, const RequiredDescription* required,
                         const ProvidedDescription* provided) {
  report_ = report;
  verdict_->setText(report.verdict());
  history_->setText(report.history());
  history_->setVisible(report.refusal.has_value());
  const bool comparable = required != nullptr && provided != nullptr;
  if (comparable) signatures_.show(*required, *provided);
  steps_->setComparable(comparable);
  steps_->show(report.diagnosis);
  steps_->orderTabs(leave());
  leftovers_->setText(report.leftovers.join('\n'));
  leftovers_->setVisible(!report.leftovers.isEmpty());
  const auto& failure = report.diagnosis.failure;
  const bool was_tried = report.refusal || report.diagnosis.is_connected;
  retry_->setText(was_tried ? Words::tr("Retry") : Words::tr("Connect"));
  retry_->setAccessibleName(was_tried ? Words::tr("Try the connection again")
                                      : Words::tr("Connect the two interfaces"));
  const bool works = report.diagnosis.is_connected && !failure;
  retry_->setVisible(!works && (!failure || failure->code != ErrorCode::kIncompatible));
  copy_->setEnabled(true);
  setAccessibleDescription(report.text());
  fit();
}

void DiagnosisCard::showMessage(const QString& sentence) {
  verdict_->setText(sentence);
  history_->hide();
  leftovers_->hide();
  retry_->hide();
  copy_->setEnabled(false);
  fit();
}

void DiagnosisCard::copyReport() {
  QGuiApplication::clipboard()->setText(report_.text());
  Q_EMIT notice(Words::tr("The report is in the clipboard"));
}

}  // namespace tendon::gui
