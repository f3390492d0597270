#include <gcm_gui/theme/icon.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/window/file/about.h>
#include <qwt_global.h>

#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace tendon::gui {
namespace {

constexpr int kLogoSize = 48;

}  // namespace

void ShowAbout(QWidget& window) {
  if (auto* open = window.findChild<QDialog*>(QStringLiteral("about"))) return open->raise();
  auto* dialog = new QDialog(&window);
  dialog->setObjectName(QStringLiteral("about"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(QStringLiteral("About gcm-gui"));
  auto* logo = new QLabel;
  logo->setPixmap(ThemeIcon(QStringLiteral("logo"), Token::kAccent).pixmap(kLogoSize));
  logo->setAccessibleName(QStringLiteral("Logo of Tendon"));
  auto* title = new QLabel(QStringLiteral("gcm-gui %1").arg(QStringLiteral(TENDON_VERSION)));
  SetRole(*title, QStringLiteral("strong"));
  auto* text =
      new QLabel(QStringLiteral("Shows and steers a system of Tendon components.\n\n"
                                "Qt %1\nQwt %2")
                     .arg(QString::fromLatin1(qVersion()), QStringLiteral(QWT_VERSION_STR)));
  text->setObjectName(QStringLiteral("about.versions"));
  text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* close = new QPushButton(QStringLiteral("Close"));
  close->setDefault(true);
  QObject::connect(close, &QPushButton::clicked, dialog, &QDialog::close);
  auto* column = new QVBoxLayout(dialog);
  column->setContentsMargins(2 * kInset, 2 * kInset, 2 * kInset, kInset);
  column->setSpacing(kInset);
  column->addWidget(logo);
  column->addWidget(title);
  column->addWidget(text);
  column->addWidget(close, 0, Qt::AlignRight);
  dialog->show();
}

}  // namespace tendon::gui
