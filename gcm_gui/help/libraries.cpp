#include <gcm_gui/help/libraries.h>

#include <gcm_gui/models/text.h>
#include <program/network_options.h>
#include <qwt_global.h>
#include <tendon/middleware/frame.h>

#include <QFile>
#include <QGuiApplication>
#include <QSysInfo>

// Makes the resources of a static library available. The macro must be used outside of namespaces.
static void LoadLicences() { Q_INIT_RESOURCE(licences); }

namespace tendon::gui {
namespace {

QString Line(const QString& name, const QString& version) { return name + ' ' + version; }

QString IceVersion() { return ToQString(program::IceVersion()); }

}  // namespace

QString Library::terms() const {
  LoadLicences();
  QStringList all;
  for (const QString& text : texts) {
    QFile file(QStringLiteral(":/tendon/licences/%1.txt").arg(text));
    [[maybe_unused]] const bool opened = file.open(QIODevice::ReadOnly);
    Q_ASSERT_X(opened, "Library::terms", qPrintable(text));
    all.append(QString::fromUtf8(file.readAll()).trimmed());
  }
  return all.join(QStringLiteral("\n\n\n"));
}

std::vector<Library> LibrariesInUse() {
  const bool with_ice = !IceVersion().isEmpty();
  const QString qt = QString::fromLatin1(qVersion());
  std::vector<Library> all{
      {QStringLiteral("Tendon"), QStringLiteral(TENDON_VERSION),
       with_ice ? QStringLiteral("BSD-3-Clause; GPL-2.0 for this program, because it contains Ice")
                : QStringLiteral("BSD-3-Clause"),
       with_ice ? QStringList{"tendon", "gpl-2.0"} : QStringList{"tendon"}},
      {QStringLiteral("Qt"), qt, with_ice ? QStringLiteral("GPL-2.0") : QStringLiteral("LGPL-3.0"),
       with_ice ? QStringList{"gpl-2.0"} : QStringList{"lgpl-3.0", "gpl-3.0"}},
      {QStringLiteral("Qwt"),
       QStringLiteral(QWT_VERSION_STR),
       QStringLiteral("LGPL-2.1 with the exceptions of the Qwt License 1.0"),
       {"qwt", "lgpl-2.1"}}};
  if (with_ice) {
    all.push_back({QStringLiteral("ZeroC Ice"),
                   IceVersion(),
                   QStringLiteral("GPL-2.0 with exceptions"),
                   {"ice", "gpl-2.0"}});
  }
  const std::vector<Library> others{{"OpenSSL", {}, "Apache-2.0", {"apache-2.0"}},
                                    {"spdlog", {}, "MIT", {"spdlog"}},
                                    {"{fmt}", {}, "MIT", {"fmt"}},
                                    {"JSON for Modern C++", {}, "MIT", {"nlohmann-json"}},
                                    {"CLI11", {}, "BSD-3-Clause", {"cli11"}},
                                    {"xxHash", {}, "BSD-2-Clause", {"xxhash"}},
                                    {"Zstandard", {}, "BSD-3-Clause", {"zstd"}},
                                    {"LZ4", {}, "BSD-2-Clause", {"lz4"}},
                                    {"zlib", {}, "Zlib", {"zlib"}}};
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

QString VersionsText() {
  QStringList lines;
  for (const Library& library : LibrariesInUse()) {
    if (!library.version.isEmpty()) lines.append(Line(library.name, library.version));
  }
  QStringList middlewares;
  for (const std::string& name : program::MiddlewareNames()) middlewares.append(ToQString(name));
  lines.append(Line(QStringLiteral("Protocol"), QString::number(FrameHeader::kProtocolVersion)) +
               QStringLiteral(" over ") + middlewares.join(QStringLiteral(" or ")));
  lines.append(QSysInfo::prettyProductName() + ' ' + QSysInfo::currentCpuArchitecture() +
               QStringLiteral(", ") + QGuiApplication::platformName());
  return lines.join('\n');
}

}  // namespace tendon::gui
