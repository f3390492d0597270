#include <gcm_gui/connect/candidate_panel.h>

#include <gcm_gui/connect/candidate_list.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/header_row.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QCoreApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

namespace tendon::gui {

CandidatePanel::CandidatePanel(ConnectMode& mode, QWidget* parent)
    : QWidget(parent),
      mode_(mode),
      model_(mode),
      head_(new HeaderRow(Words::tr("Connect"))),
      about_(new QLabel),
      field_(new QLineEdit),
      list_(new CandidateList(model_)),
      refusal_(new QLabel) {
  setObjectName(QStringLiteral("candidatePanel"));
  setAccessibleName(Words::tr("Candidates for a connection"));
  setAutoFillBackground(true);
  auto* leave = new QLabel(Words::tr("Esc cancels"));
  SetRole(*leave, QStringLiteral("dim"));
  head_->addRight(leave);
  about_->setObjectName(QStringLiteral("candidates.about"));
  about_->setWordWrap(true);
  SetRole(*about_, QStringLiteral("dim"));
  field_->setObjectName(QStringLiteral("candidates.filter"));
  field_->setAccessibleName(Words::tr("Filter the candidates"));
  field_->setPlaceholderText(Words::tr("Filter; Enter or 1 to 9 picks"));
  field_->setClearButtonEnabled(true);
  field_->installEventFilter(this);
  list_->installEventFilter(this);

  auto* above = new QVBoxLayout;
  above->setContentsMargins(kInset, 2 * kGrid, kInset, 2 * kGrid);
  above->setSpacing(2 * kGrid);
  above->addWidget(about_);
  above->addWidget(field_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(head_);
  column->addLayout(above);
  column->addWidget(list_, 1);
  refusal_->setObjectName(QStringLiteral("candidates.refusal"));
  refusal_->setTextFormat(Qt::PlainText);
  refusal_->setWordWrap(true);
  refusal_->setMargin(kInset);
  refusal_->hide();
  column->addWidget(refusal_);

  connect(field_, &QLineEdit::textChanged, &model_, &CandidatesModel::setFilter);
  connect(list_, &QTreeView::clicked, this, &CandidatePanel::pick);
  connect(list_, &QTreeView::entered, this, &CandidatePanel::point);
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          &CandidatePanel::point);
  connect(&mode, &ConnectMode::changed, this, &CandidatePanel::showMode);
  showMode();
}

void CandidatePanel::showMode() {
  const bool other = !mode_.active() || shown_ != mode_.chosen();
  shown_ = mode_.active() ? std::optional(mode_.chosen()) : std::nullopt;
  if (other) field_->clear();
  if (!shown_) return;
  const bool from_required = shown_->side == Side::kRequired;
  const QString name = ToQString(ToString(shown_->name));
  head_->setTitle(mode_.former() ? Words::tr("Replace") : Words::tr("Connect"));
  if (mode_.former()) {
    about_->setText(Words::tr("%1 is connected to %2. Other candidates:")
                        .arg(name, ToQString(ToString(*mode_.former()))));
  } else if (from_required) {
    about_->setText(Words::tr("Provided interfaces for %1:").arg(name));
  } else {
    about_->setText(Words::tr("Required interfaces for %1:").arg(name));
  }
}

void CandidatePanel::showRefusal(const QString& title, const QStringList& reasons) {
  refusal_->setText((QStringList{title} + reasons).join('\n'));
  refusal_->setVisible(!title.isEmpty());
}

void CandidatePanel::focusFilter() { field_->setFocus(Qt::ShortcutFocusReason); }

void CandidatePanel::point(const QModelIndex& index) {
  Q_EMIT pointed(model_.fits(index) ? model_.portOf(index) : std::nullopt);
}

void CandidatePanel::pick(const QModelIndex& index) {
  if (const auto port = model_.portOf(index)) mode_.pick(*port);
}

bool CandidatePanel::press(int key) {
  const QModelIndex current = list_->currentIndex();
  if (key == Qt::Key_Return || key == Qt::Key_Enter) {
    pick(current.isValid() ? current : model_.index(0, 0, {}));
  } else if (key >= Qt::Key_1 && key <= Qt::Key_9 && field_->text().isEmpty()) {
    mode_.pickNumber(key - Qt::Key_0);
  } else {
    return false;
  }
  return true;
}

bool CandidatePanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress && mode_.active()) {
    const auto& pressed = static_cast<const QKeyEvent&>(*event);
    if (press(pressed.key())) return true;
    const bool moves = pressed.key() == Qt::Key_Up || pressed.key() == Qt::Key_Down;
    if (moves && watched == field_) {
      QKeyEvent copy(pressed.type(), pressed.key(), pressed.modifiers());
      QCoreApplication::sendEvent(list_, &copy);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace tendon::gui
