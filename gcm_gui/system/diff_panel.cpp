#include <gcm_gui/system/diff_panel.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/system/system_parts.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/row_view.h>

#include <QCheckBox>
#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <utility>

namespace tendon::gui {
namespace {

QPushButton* MakeButton(const QString& text, const char* name, QHBoxLayout& row) {
  auto* button = new QPushButton(text);
  button->setObjectName(QString::fromLatin1(name));
  button->setAutoDefault(true);
  row.addWidget(button);
  return button;
}

/// Fills a page: a line of text, a list below it, and buttons below the list.
QVBoxLayout* Frame(QWidget& page, QLabel& words, RowView& list, QHBoxLayout& buttons) {
  auto* column = new QVBoxLayout(&page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  words.setContentsMargins(kInset, 2 * kGrid, kInset, 2 * kGrid);
  words.setWordWrap(true);
  column->addWidget(&words);
  column->addWidget(&list, 1);
  buttons.setContentsMargins(kInset, 2 * kGrid, kInset, 2 * kGrid);
  buttons.setSpacing(2 * kGrid);
  column->addLayout(&buttons);
  return column;
}

}  // namespace

DiffPanel::DiffPanel(SystemDocument& document, PlanController& restore, const QString& refusal,
                     QWidget* parent)
    : QWidget(parent),
      document_(document),
      restore_(restore),
      refusal_(refusal),
      pages_(new QStackedWidget) {
  setObjectName(QStringLiteral("diffPanel"));
  setAccessibleName(Words::tr("The running system and its file"));
  setAutoFillBackground(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(pages_);
  pages_->addWidget(buildDiff());
  pages_->addWidget(buildPlan());
  connect(&document, &SystemDocument::changed, this, &DiffPanel::showDiff);
  connect(&restore, &PlanController::changed, this, &DiffPanel::showPlan);
  showDiff();
  showPlan();
}

QWidget* DiffPanel::buildDiff() {
  auto* page = new QWidget;
  summary_ = new QLabel;
  summary_->setObjectName(QStringLiteral("diff.summary"));
  diff_list_ = MakeRowList(differences_, QStringLiteral("differences"),
                           Words::tr("Differences between the running system and its file"), {});
  auto* buttons = new QHBoxLayout;
  apply_ = MakeButton(Words::tr("Apply →"), "diff.apply", *buttons);
  apply_->setToolTip(Words::tr("Change the running system to match this line of the file"));
  update_ = MakeButton(Words::tr("← Update file"), "diff.update", *buttons);
  update_->setToolTip(Words::tr("Change this line of the file to match the running system"));
  buttons->addStretch();
  restore_all_ = MakeButton(Words::tr("Restore all…"), "diff.restore", *buttons);
  SetRole(*restore_all_, QStringLiteral("primary"));
  Frame(*page, *summary_, *diff_list_, *buttons);
  connect(apply_, &QPushButton::clicked, this, &DiffPanel::previewOne);
  connect(update_, &QPushButton::clicked, this, &DiffPanel::updateOne);
  connect(restore_all_, &QPushButton::clicked, this, &DiffPanel::previewAll);
  connect(diff_list_, &QTreeView::activated, this, &DiffPanel::previewOne);
  connect(diff_list_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          &DiffPanel::showButtons);
  return page;
}

QWidget* DiffPanel::buildPlan() {
  auto* page = new QWidget;
  plan_text_ = new QLabel;
  plan_text_->setObjectName(QStringLiteral("plan.summary"));
  step_list_ = MakeRowList(steps_, QStringLiteral("steps"), Words::tr("Steps of the plan"), {});
  auto* buttons = new QHBoxLayout;
  back_ = MakeButton(Words::tr("Back"), "plan.back", *buttons);
  buttons->addStretch();
  go_on_ = new QCheckBox(Words::tr("Continue after an error"));
  go_on_->setObjectName(QStringLiteral("plan.goOn"));
  buttons->addWidget(go_on_);
  stop_ = MakeButton(Words::tr("Stop"), "plan.stop", *buttons);
  undo_ = MakeButton(Words::tr("Undo restore"), "plan.undo", *buttons);
  carry_out_ = MakeButton(Words::tr("Carry out"), "plan.carryOut", *buttons);
  SetRole(*carry_out_, QStringLiteral("primary"));
  Frame(*page, *plan_text_, *step_list_, *buttons);
  connect(back_, &QPushButton::clicked, &restore_, &PlanController::leave);
  connect(stop_, &QPushButton::clicked, &restore_, &PlanController::stop);
  connect(undo_, &QPushButton::clicked, &restore_, &PlanController::undo);
  connect(carry_out_, &QPushButton::clicked, this, [this] {
    restore_.execute(go_on_->isChecked() ? AfterError::kGoOn : AfterError::kStop);
  });
  return page;
}

const SystemDifference* DiffPanel::currentLine() const {
  const QModelIndex index = diff_list_->currentIndex();
  return index.isValid() ? &differences_.row(index.row()) : nullptr;
}

void DiffPanel::previewAll() {
  if (document_.isOpen()) restore_.preview(document_.file(), document_.name());
}

void DiffPanel::previewOne() {
  const SystemDifference* line = currentLine();
  if (line == nullptr) return;
  restore_.preview(WithPartOf(WholeSystem(document_.catalogue()), document_.file(), line->what),
                   Words::tr("%1: as in the file").arg(ToQString(line->what)));
}

void DiffPanel::updateOne() {
  if (const SystemDifference* line = currentLine()) document_.update(line->what);
}

void DiffPanel::showDiff() {
  const SystemDifference* line = currentLine();
  const std::string chosen = line != nullptr ? line->what : std::string();
  differences_.show(document_.comparison());
  summary_->setText(document_.isOpen() ? SummaryOf(document_.comparison())
                                       : Words::tr("No system file is open."));
  diff_list_->setEmptyText(
      document_.isOpen()
          ? Words::tr("The running system matches the file.")
          : Words::tr("Ctrl+S saves the running system; Ctrl+O opens a saved system."));
  choose(chosen);
  showButtons();
}

/// Selects the difference that was selected before. If it does not exist any more, selects none.
void DiffPanel::choose(const std::string& what) {
  int row = 0;
  while (row < differences_.rowCount() && !what.empty() && differences_.row(row).what != what)
    ++row;
  diff_list_->setCurrentIndex(differences_.index(row));
}

void DiffPanel::allow(QPushButton& button, bool allowed) const {
  button.setEnabled(allowed && refusal_.isEmpty());
  if (!refusal_.isEmpty()) button.setToolTip(refusal_);
}

void DiffPanel::showButtons() {
  const bool any = currentLine() != nullptr;
  allow(*apply_, any);
  update_->setEnabled(any);
  restore_all_->setEnabled(document_.isOpen() && differences_.rowCount() > 0);
}

QString DiffPanel::planText() const {
  const Plan& plan = restore_.plan();
  const PlanOutcome& outcome = restore_.outcome();
  const auto untouched = static_cast<std::int64_t>(plan.untouched);
  switch (restore_.phase()) {
    case PlanController::Phase::kIdle:
      return {};
    case PlanController::Phase::kAsking:
      return Words::tr("Target %1: asking the processes for their classes…").arg(restore_.goal());
    case PlanController::Phase::kPreview:
      return Words::tr("Target %1: %2; %3")
          .arg(restore_.goal(),
               plan.steps.empty() ? Words::tr("there is nothing to do")
                                  : CountText(static_cast<std::int64_t>(plan.steps.size()),
                                              Words::tr("%1 step"), Words::tr("%1 steps")),
               untouched == 0
                   ? Words::tr("everything changes")
                   : Words::tr("will not touch ") +
                         CountText(untouched, Words::tr("%1 item"), Words::tr("%1 items")));
    case PlanController::Phase::kRunning:
      return Words::tr("Target %1: step %2 of %3")
          .arg(restore_.goal())
          .arg(restore_.outcomes().size() + 1)
          .arg(plan.steps.size());
    case PlanController::Phase::kDone:
      return Words::tr("Target %1: %2 done, %3 failed, %4 remaining")
          .arg(restore_.goal())
          .arg(outcome.done)
          .arg(outcome.failed)
          .arg(outcome.left);
  }
  return {};
}

void DiffPanel::showPlan() {
  const PlanController::Phase phase = restore_.phase();
  const int page = phase == PlanController::Phase::kIdle ? 0 : 1;
  const bool is_new = phase != std::exchange(shown_phase_, phase);
  const bool turned = pages_->currentIndex() != page;
  steps_.show(restore_);
  plan_text_->setText(planText());
  const bool waits = phase == PlanController::Phase::kPreview;
  carry_out_->setVisible(waits);
  go_on_->setVisible(waits);
  allow(*carry_out_, !restore_.plan().steps.empty());
  stop_->setVisible(phase == PlanController::Phase::kRunning);
  undo_->setVisible(restore_.canUndo());
  back_->setEnabled(phase != PlanController::Phase::kRunning);
  pages_->setCurrentIndex(page);
  if (!is_new) return;
  // Moves the focus away from the buttons, because a key that is still pressed could press another
  // button.
  if (waits || phase == PlanController::Phase::kAsking) step_list_->setFocus();
  if (phase == PlanController::Phase::kDone) back_->setFocus();
  if (turned && page == 0) diff_list_->setFocus();
}

}  // namespace tendon::gui
