#include <gcm_gui/help/about.h>

#include <gcm_gui/help/libraries.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/icon.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace tendon::gui {
namespace {

constexpr int kLogoSize = 48;
constexpr QSize kSize{640, 560};

QLayout* MakeHead() {
  auto* logo = new QLabel;
  logo->setPixmap(ThemeIcon(QStringLiteral("logo"), Token::kAccent).pixmap(kLogoSize));
  logo->setAccessibleName(Words::tr("Logo of Tendon"));
  auto* title = new QLabel(QStringLiteral("gcm-gui"));
  SetRole(*title, QStringLiteral("strong"));
  auto* meaning = new QLabel(Words::tr("Shows and controls a system of Tendon components."));
  SetRole(*meaning, QStringLiteral("dim"));
  auto* words = new QVBoxLayout;
  words->setSpacing(kGrid);
  words->addStretch();
  words->addWidget(title);
  words->addWidget(meaning);
  words->addStretch();
  auto* head = new QHBoxLayout;
  head->setSpacing(kInset);
  head->addWidget(logo);
  head->addLayout(words, 1);
  return head;
}

QLabel* MakeVersions() {
  auto* versions = new QLabel(VersionsText());
  versions->setObjectName(QStringLiteral("about.versions"));
  versions->setAccessibleName(Words::tr("Versions"));
  versions->setTextFormat(Qt::PlainText);
  versions->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  SetRole(*versions, QStringLiteral("mono"));
  return versions;
}

void AddTerms(QVBoxLayout& column) {
  const auto libraries = LibrariesInUse();
  auto* choice = new QComboBox;
  choice->setObjectName(QStringLiteral("about.library"));
  choice->setAccessibleName(Words::tr("Library"));
  for (const Library& library : libraries) {
    choice->addItem(library.name + QStringLiteral(" – ") + library.licence);
  }
  auto* text = new QPlainTextEdit;
  text->setObjectName(QStringLiteral("about.terms"));
  text->setAccessibleName(Words::tr("Terms of the library"));
  text->setReadOnly(true);
  text->setTabChangesFocus(true);
  text->setFont(Theme::instance().smallMono());
  const auto show = [text, libraries](int row) {
    text->setPlainText(libraries[static_cast<std::size_t>(row)].terms());
  };
  QObject::connect(choice, &QComboBox::currentIndexChanged, text, show);
  show(0);
  auto* title = new QLabel(Words::tr("Libraries in this program, and their licences"));
  SetRole(*title, QStringLiteral("strong"));
  column.addWidget(title);
  column.addWidget(choice);
  column.addWidget(text, 1);
}

QLayout* MakeButtons(QDialog& dialog) {
  auto* copy = new QPushButton(Words::tr("Copy versions"));
  copy->setObjectName(QStringLiteral("about.copy"));
  QObject::connect(copy, &QPushButton::clicked, &dialog, [copy] {
    QGuiApplication::clipboard()->setText(VersionsText());
    copy->setText(Words::tr("Copied"));
  });
  auto* close = new QPushButton(Words::tr("Close"));
  close->setObjectName(QStringLiteral("about.close"));
  close->setDefault(true);
  QObject::connect(close, &QPushButton::clicked, &dialog, &QDialog::close);
  auto* row = new QHBoxLayout;
  row->setSpacing(2 * kGrid);
  row->addStretch();
  row->addWidget(copy);
  row->addWidget(close);
  return row;
}

}  // namespace

void ShowAbout(QWidget& window) {
  if (auto* open = window.findChild<QDialog*>(QStringLiteral("about"))) return open->raise();
  auto* dialog = new QDialog(&window);
  dialog->setObjectName(QStringLiteral("about"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(Words::tr("About gcm-gui"));
  auto* column = new QVBoxLayout(dialog);
  column->setContentsMargins(2 * kInset, 2 * kInset, 2 * kInset, kInset);
  column->setSpacing(kInset);
  column->addLayout(MakeHead());
  column->addWidget(MakeVersions());
  AddTerms(*column);
  column->addLayout(MakeButtons(*dialog));
  dialog->resize(kSize);
  dialog->show();
}

}  // namespace tendon::gui
