#include <gcm_gui/plot/controls/curve_editor.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/series/time_shift.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace tendon::gui {
namespace {

constexpr int kWidth = 300;

QString HintOn(const QString& number) {
  return number.contains(',') ? Words::tr(": use a point as the decimal sign") : QString();
}

}  // namespace

CurveEditor::CurveEditor(const QString& name, const QString& unit, const CurveLook& look,
                         const QStringList& axes, QWidget* parent)
    : QFrame(parent, Qt::Popup),
      unit_(unit),
      fields_(new QFormLayout),
      factor_(new QLineEdit),
      offset_(new QLineEdit),
      axis_(new QComboBox),
      status_(new QLabel),
      accept_(new QPushButton(Words::tr("Apply"))) {
  setObjectName("curveEditor");
  setAttribute(Qt::WA_DeleteOnClose);
  SetRole(*this, "card");
  setAccessibleName(Words::tr("Scale, offset and axis of ") + name);
  build(name);
  fill(look, axes);
  connect(factor_, &QLineEdit::textChanged, this, &CurveEditor::check);
  connect(offset_, &QLineEdit::textChanged, this, &CurveEditor::check);
  connect(axis_, &QComboBox::editTextChanged, this, &CurveEditor::check);
  connect(accept_, &QPushButton::clicked, this, &CurveEditor::accept);
  check();
  factor_->setFocus();
  factor_->selectAll();
}

void CurveEditor::build(const QString& name) {
  setFixedWidth(kWidth);
  auto* title = new QLabel(name);
  SetRole(*title, "strong");
  title->setTextFormat(Qt::PlainText);
  factor_->setObjectName("curveEditor.factor");
  offset_->setObjectName("curveEditor.offset");
  axis_->setObjectName("curveEditor.axis");
  axis_->setEditable(true);
  axis_->setInsertPolicy(QComboBox::NoInsert);
  // A combo box does not forward Enter and Escape.
  axis_->lineEdit()->installEventFilter(this);
  axis_->setToolTip(
      Words::tr("Curves with the same name here share one axis; a new name makes a new axis"));
  status_->setObjectName("curveEditor.status");
  status_->setWordWrap(true);
  status_->setTextFormat(Qt::PlainText);
  SetRole(*accept_, "primary");
  accept_->setObjectName("curveEditor.accept");
  auto* plain = new QPushButton(Words::tr("Unscaled"));
  plain->setObjectName("curveEditor.plain");
  plain->setToolTip(Words::tr("Removes scale and offset, and uses the axis of the unit"));
  connect(plain, &QPushButton::clicked, this, [this] {
    factor_->setText("1");
    offset_->setText("0");
    axis_->setCurrentIndex(0);
    accept();
  });
  fields_->setSpacing(2 * kGrid);
  fields_->addRow(Words::tr("Scale"), factor_);
  fields_->addRow(Words::tr("Offset"), offset_);
  fields_->addRow(Words::tr("Axis"), axis_);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(plain);
  buttons->addStretch();
  buttons->addWidget(accept_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kInset, kInset, kInset, kInset);
  column->setSpacing(2 * kGrid);
  column->addWidget(title);
  column->addLayout(fields_);
  column->addWidget(status_);
  column->addLayout(buttons);
  for (QLineEdit* field : {factor_, offset_}) field->setFont(Theme::instance().mono());
  factor_->setAccessibleName(Words::tr("Scale"));
  offset_->setAccessibleName(Words::tr("Offset"));
  axis_->setAccessibleName(Words::tr("Axis"));
}

void CurveEditor::addShift(std::int64_t shift_ns) {
  shift_ = new QLineEdit(ShiftText(shift_ns));
  shift_->setObjectName("curveEditor.shift");
  shift_->setAccessibleName(Words::tr("Shift"));
  shift_->setToolTip(
      Words::tr("This time is added to all times of the recording: “-12.5” or “+2 h 03 min”"));
  shift_->setFont(Theme::instance().mono());
  fields_->insertRow(0, Words::tr("Shift"), shift_);
  setTabOrder(shift_, factor_);
  connect(shift_, &QLineEdit::textChanged, this, &CurveEditor::check);
  shift_->setFocus();
  shift_->selectAll();
  check();
}

QString CurveEditor::refusalOfShift() const {
  if (shift_ == nullptr || ShiftIn(shift_->text())) return {};
  return Words::tr(
             "The shift “%1” is no time, or over 100 years: write seconds, such as -12.5, or "
             "+2 h 03 min")
             .arg(shift_->text()) +
         HintOn(shift_->text());
}

void CurveEditor::fill(const CurveLook& look, const QStringList& axes) {
  factor_->setText(ExactText(look.scaling.factor));
  offset_->setText(ExactText(look.scaling.offset));
  axis_->addItem(Words::tr("Axis of its unit"));
  axis_->addItems(axes);
  if (look.axis.isEmpty()) {
    axis_->setCurrentIndex(0);
  } else {
    axis_->setEditText(look.axis);
  }
}

QString CurveEditor::read(CurveLook& look) const {
  if (const QString refusal = refusalOfShift(); !refusal.isEmpty()) return refusal;
  const auto factor = NumberIn(factor_->text());
  if (!factor)
    return Words::tr("The scale “%1” is not a number").arg(factor_->text()) +
           HintOn(factor_->text());
  const auto offset = NumberIn(offset_->text());
  if (!offset)
    return Words::tr("The offset “%1” is not a number").arg(offset_->text()) +
           HintOn(offset_->text());
  const QString axis = axis_->currentText().trimmed();
  look = {.scaling = {.factor = *factor, .offset = *offset},
          .axis = axis == axis_->itemText(0) ? QString() : axis};
  return RefusalOf(look).value_or(QString());
}

void CurveEditor::check() {
  CurveLook look;
  const QString refusal = read(look);
  accept_->setEnabled(refusal.isEmpty());
  SetRole(*status_, refusal.isEmpty() ? "dim" : "bad");
  const QString sum = Words::tr("Shown: value %1").arg(UnitOf({}, look.scaling));
  status_->setText(!refusal.isEmpty()      ? refusal
                   : look.scaling.isNone() ? Words::tr("Shown unscaled")
                                           : sum + (unit_.isEmpty() ? "" : ", " + unit_));
  adjustSize();
}

void CurveEditor::accept() {
  CurveLook look;
  if (!read(look).isEmpty()) return;
  Q_EMIT accepted(look);
  if (shift_ != nullptr) Q_EMIT shiftAccepted(*ShiftIn(shift_->text()));
  close();
}

bool CurveEditor::takesKey(int key) {
  if (key == Qt::Key_Escape) {
    close();
    return true;
  }
  if (key != Qt::Key_Return && key != Qt::Key_Enter) return false;
  auto* button = qobject_cast<QPushButton*>(focusWidget());
  button != nullptr ? button->click() : accept();
  return true;
}

void CurveEditor::keyPressEvent(QKeyEvent* event) {
  if (!takesKey(event->key())) QFrame::keyPressEvent(event);
}

bool CurveEditor::eventFilter(QObject* watched, QEvent* event) {
  const bool is_key = event->type() == QEvent::KeyPress;
  if (is_key && takesKey(static_cast<QKeyEvent*>(event)->key())) return true;
  return QFrame::eventFilter(watched, event);
}

}  // namespace tendon::gui
