#include <gcm_gui/language/language.h>

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QTranslator>
#include <clocale>
#include <memory>

namespace tendon::gui {
namespace {

constexpr auto kFolder = ":/tendon/language";

/// Installs the first available translation in the user's list of languages. Installs none if
/// English comes before it in the list.
void Install(const QLocale& locale, const QString& name, const QString& folder) {
  for (const QString& language : locale.uiLanguages()) {
    if (QLocale(language).language() == QLocale::English) return;
    auto translator = std::make_unique<QTranslator>();
    if (!translator->load(name + '_' + QString(language).replace('-', '_'), folder)) continue;
    QCoreApplication::installTranslator(translator.get());
    translator.release()->setParent(QCoreApplication::instance());
    return;
  }
}

}  // namespace

QStringList Languages() {
  QStringList languages = QDir(kFolder).entryList();
  for (auto& one : languages) one = one.section('_', 1).section('.', 0, 0);
  return languages;
}

void SetLanguage(const QLocale& locale) {
  QLocale::setDefault(QLocale::c());
  std::setlocale(LC_NUMERIC, "C");  // NOLINT(concurrency-mt-unsafe): before other threads
  Install(locale, QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  Install(locale, QStringLiteral("window"), kFolder);
}

}  // namespace tendon::gui
