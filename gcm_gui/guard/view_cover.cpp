#include <gcm_gui/guard/view_cover.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace tendon::gui {

ViewCover::ViewCover(QWidget& view) : QWidget(&view) {
  setObjectName(QStringLiteral("viewCover"));
  setAutoFillBackground(true);
  setCursor(Qt::ArrowCursor);
  const auto apply_theme = [this] {
    QPalette colors = palette();
    colors.setColor(QPalette::Window, Theme::instance().color(Token::kPanel));
    setPalette(colors);
  };
  apply_theme();
  connect(&Theme::instance(), &Theme::changed, this, apply_theme);
  auto* words = MakeTextLine(QStringLiteral("viewCover.words"), QStringLiteral("dim"));
  words->setText(Words::tr("This view is not drawn because of an error: see Problems."));
  words->setAlignment(Qt::AlignCenter);
  auto* again = new QPushButton(Words::tr("Show again"));
  again->setObjectName(QStringLiteral("viewCover.again"));
  connect(again, &QPushButton::clicked, this, &ViewCover::shownAgainRequested);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kInset, kGrid, kInset, kGrid);
  column->setSpacing(2 * kGrid);
  column->addStretch();
  column->addWidget(words);
  column->addWidget(again, 0, Qt::AlignHCenter);
  column->addStretch();
  setAccessibleName(words->text());
  view.installEventFilter(this);
  setGeometry(view.rect());
  show();
  raise();
}

void ViewCover::leave() {
  if (isAncestorOf(window()->focusWidget())) parentWidget()->setFocus(Qt::OtherFocusReason);
  hide();
  deleteLater();
}

bool ViewCover::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parent() && event->type() == QEvent::Resize) setGeometry(parentWidget()->rect());
  if (watched == parent() && event->type() == QEvent::ChildAdded) raise();
  return QWidget::eventFilter(watched, event);
}

}  // namespace tendon::gui
