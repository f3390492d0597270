#include <gcm_gui/diagnosis/step_list.h>

#include <gcm_gui/diagnosis/diagnosis_report.h>
#include <gcm_gui/diagnosis/signature_model.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/link_button.h>
#include <gcm_gui/views/row_delegate.h>
#include <gcm_gui/views/row_view.h>

#include <QClipboard>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace tendon::gui {
namespace {

constexpr std::size_t kSignatureStep = 4;
constexpr int kMaxDiffRows = 9;  // rows of the comparison; with more rows, it scrolls
constexpr int kStepMarkWidth = 16;
constexpr int kNumberWidth = 14;
constexpr int kLinkHeight = 20;  // lower than other links, because it stands in a line of text
constexpr int kVerdictWidth = 200;

struct VerdictLook {
  const char* glyph;
  const char* word;
  const char* role;
};

VerdictLook LookOf(DiagnosisStep::Verdict verdict) {
  switch (verdict) {
    case DiagnosisStep::Verdict::kGood:
      return {"✓", QT_TRANSLATE_NOOP("Words", "good"), "ok"};
    case DiagnosisStep::Verdict::kBad:
      return {"✗", QT_TRANSLATE_NOOP("Words", "bad"), "bad"};
    case DiagnosisStep::Verdict::kNotReached:
      break;
  }
  return {"·", QT_TRANSLATE_NOOP("Words", "not reached"), "dim"};
}

RowView* MakeSides(SignatureModel& model) {
  RowView* sides = MakeRowList(model, QStringLiteral("why.signatures"),
                               Words::tr("The needed and the offered members, side by side"),
                               Words::tr("Neither interface has a member."));
  sides->rows().setAllLeft(true);
  sides->setHeaderHidden(false);
  sides->header()->setSectionResizeMode(SignatureModel::kNeeded, QHeaderView::Stretch);
  sides->header()->setSectionResizeMode(SignatureModel::kOffered, QHeaderView::Stretch);
  sides->header()->setSectionResizeMode(SignatureModel::kVerdict, QHeaderView::Fixed);
  sides->header()->resizeSection(SignatureModel::kVerdict, kVerdictWidth);
  return sides;
}

}  // namespace

StepList::StepList(SignatureModel& signatures, QWidget* parent)
    : QWidget(parent), sides_(MakeSides(signatures)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  sides_->setParent(this);
  sides_->hide();
  const auto fit = [this, &signatures] {
    const int rows = std::min(kMaxDiffRows, std::max(1, signatures.rowCount()));
    sides_->setFixedHeight((rows + 1) * kRowHeight);
  };
  connect(&signatures, &QAbstractItemModel::modelReset, this, fit);
  fit();
}

void StepList::show(const Diagnosis& diagnosis) {
  if (diagnosis.steps == shown_ && comparable_ == compares_ && rows_ != nullptr) return;
  shown_ = diagnosis.steps;
  compares_ = comparable_;
  const bool was_shown = toggle_ != nullptr && toggle_->isChecked();
  const bool had_focus = toggle_ != nullptr && toggle_->hasFocus();
  sides_->setParent(this);
  sides_->hide();
  delete rows_;
  toggle_ = nullptr;
  rows_ = new QWidget;
  grid_ = new QGridLayout(rows_);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(kGrid);
  grid_->setVerticalSpacing(kGrid + 2);
  grid_->setColumnMinimumWidth(0, kStepMarkWidth);
  grid_->setColumnMinimumWidth(1, kNumberWidth);
  grid_->setColumnStretch(2, 1);
  int number = 0;
  for (const DiagnosisStep& step : shown_) addStep(++number, step);
  layout()->addWidget(rows_);
  rows_->show();  // at once, so that the keys work immediately
  if (toggle_ == nullptr) return;
  toggle_->setChecked(was_shown);
  if (had_focus) toggle_->setFocus();
}

void StepList::orderTabs(QWidget& before) {
  QWidget* last = &before;
  for (auto* link : findChildren<QToolButton*>()) {
    setTabOrder(last, link);
    last = link;
    if (link == toggle_) setTabOrder(std::exchange(last, sides_), sides_);
  }
}

QLabel* StepList::addText(const QString& text, const QString& role) {
  auto* label = new QLabel(text);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  SetRole(*label, role);
  return label;
}

void StepList::addStep(int number, const DiagnosisStep& step) {
  const VerdictLook look = LookOf(step.verdict);
  const QString role = QString::fromLatin1(look.role);
  const int row = grid_->rowCount();
  QLabel* mark = addText(QString::fromUtf8(look.glyph), role);
  mark->setAlignment(Qt::AlignTop | Qt::AlignHCenter);
  QLabel* count = addText(QString::number(number), QStringLiteral("dim mono"));
  count->setAlignment(Qt::AlignTop | Qt::AlignRight);
  const bool reached = step.verdict != DiagnosisStep::Verdict::kNotReached;
  QLabel* text = addText(ToQString(step.text), reached ? QString() : QStringLiteral("dim"));
  text->setObjectName(QStringLiteral("why.step%1").arg(number));
  text->setAccessibleName(
      Words::tr("Step %1, %2: %3").arg(number).arg(Words::tr(look.word), ToQString(step.text)));
  grid_->addWidget(mark, row, 0);
  grid_->addWidget(count, row, 1);
  auto* line = new QHBoxLayout;
  line->setSpacing(2 * kGrid);
  line->addWidget(text, 1);
  grid_->addLayout(line, row, 2);
  for (const auto& detail : step.details) {
    grid_->addWidget(addText(ToQString(detail), QStringLiteral("dim")), grid_->rowCount(), 2);
  }
  if (!step.fix.empty()) addFix(step);
  if (number != static_cast<int>(kSignatureStep) || !comparable_) return;
  toggle_ = MakeLinkButton(Words::tr("Show side by side"), QStringLiteral("why.sides"));
  toggle_->setCheckable(true);
  toggle_->setFocusPolicy(Qt::StrongFocus);
  toggle_->setFixedHeight(kLinkHeight);
  line->addWidget(toggle_, 0, Qt::AlignTop);
  addSides();
}

void StepList::addFix(const DiagnosisStep& step) {
  const QString command = CommandOfFix(step.fix);
  auto* line = new QHBoxLayout;
  line->setSpacing(2 * kGrid);
  QLabel* words = addText(Words::tr("fix: ") + ToQString(step.fix), {});
  words->setObjectName(QStringLiteral("why.fix"));
  line->addWidget(words, 1);
  QToolButton* copy = MakeLinkButton(Words::tr("Copy"), QStringLiteral("why.copyFix"));
  copy->setAccessibleName(Words::tr("Copy the fix: ") + command);
  copy->setToolTip(command);
  copy->setFocusPolicy(Qt::StrongFocus);
  copy->setFixedHeight(kLinkHeight);
  connect(copy, &QToolButton::clicked, this, [this, command] {
    QGuiApplication::clipboard()->setText(command);
    Q_EMIT copied(Words::tr("Copied: ") + command);
  });
  line->addWidget(copy, 0, Qt::AlignTop);
  grid_->addLayout(line, grid_->rowCount(), 2);
}

void StepList::addSides() {
  grid_->addWidget(sides_, grid_->rowCount(), 2);
  connect(toggle_, &QToolButton::toggled, this, &StepList::showSides);
}

void StepList::showSides(bool shown) {
  sides_->setVisible(shown);
  toggle_->setText(shown ? Words::tr("Hide the comparison") : Words::tr("Show side by side"));
  toggle_->setAccessibleName(toggle_->text());
}

}  // namespace tendon::gui
