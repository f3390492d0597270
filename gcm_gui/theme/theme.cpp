#include <gcm_gui/theme/theme.h>

#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/system_appearance.h>
#include <gcm_gui/theme/tendon_style.h>

#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QLabel>
#include <QPalette>
#include <QPointer>
#include <QStyle>
#include <QWidget>
#include <array>
#include <utility>

// Loads the resources, which are in a static library. The macro must be used outside of namespaces.
static void LoadResources() { Q_INIT_RESOURCE(theme); }

namespace tendon::gui {
namespace {

constexpr auto kTextFamily = "Inter";
constexpr auto kMonoFamily = "JetBrains Mono";

QFont InstalledFont(const QString& family, QFontDatabase::SystemFont otherwise, int pixels) {
  QFont font =
      QFontDatabase::hasFamily(family) ? QFont(family) : QFontDatabase::systemFont(otherwise);
  font.setPixelSize(pixels);
  return font;
}

QFont Resized(QFont font, int pixels) {
  font.setPixelSize(pixels);
  return font;
}

QPalette PaletteOf(const Theme& theme) {
  const auto roles = std::to_array<std::pair<QPalette::ColorRole, Token>>({
      {QPalette::Window, Token::kPanel},
      {QPalette::WindowText, Token::kText},
      {QPalette::Base, Token::kPanel},
      {QPalette::AlternateBase, Token::kRaised},
      {QPalette::Text, Token::kText},
      {QPalette::PlaceholderText, Token::kDim},
      {QPalette::Button, Token::kRaised},
      {QPalette::ButtonText, Token::kText},
      {QPalette::BrightText, Token::kBad},
      {QPalette::Highlight, Token::kSelection},
      {QPalette::HighlightedText, Token::kText},
      {QPalette::Link, Token::kAccent},
      {QPalette::LinkVisited, Token::kAccent},
      {QPalette::ToolTipBase, Token::kRaised},
      {QPalette::ToolTipText, Token::kText},
      {QPalette::Light, Token::kRaised},
      {QPalette::Midlight, Token::kRaised},
      {QPalette::Mid, Token::kLine},
      {QPalette::Dark, Token::kLine},
      {QPalette::Shadow, Token::kCanvas},
  });
  QPalette palette;
  for (const auto& [role, token] : roles) palette.setColor(role, theme.color(token));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, theme.color(Token::kStale));
  }
  return palette;
}

}  // namespace

Theme& Theme::instance() {
  static QPointer<Theme> theme;
  Q_ASSERT(qApp != nullptr);
  if (theme.isNull()) {
    LoadResources();
    auto* made = new Theme(qApp);
    made->applyLook();
    theme = made;
  }
  return *theme;
}

Theme::Theme(QObject* parent)
    : QObject(parent),
      system_(new SystemAppearance(this)),
      appearance_(system_->appearance()),
      text_(InstalledFont(kTextFamily, QFontDatabase::GeneralFont, kTextSize)),
      strong_(text_),
      mono_(InstalledFont(kMonoFamily, QFontDatabase::FixedFont, kMonoSize)),
      small_(Resized(text_, kSmallSize)),
      small_mono_(Resized(mono_, kSmallSize)) {
  connect(system_, &SystemAppearance::changed, this, &Theme::follow);
  QApplication::setStyle(new TendonStyle);
}

void Theme::choose(Choice choice) {
  choice_ = choice;
  follow();
}

QColor Theme::color(Token token, double opacity) const {
  QColor color = ColorOf(token, appearance_);
  color.setAlphaF(static_cast<float>(opacity));
  return color;
}

void Theme::follow() {
  Appearance wanted = system_->appearance();
  if (choice_ == Choice::kDark) wanted = Appearance::kDark;
  if (choice_ == Choice::kLight) wanted = Appearance::kLight;
  if (wanted == appearance_) return;
  appearance_ = wanted;
  applyLook();
  Q_EMIT changed();
}

void Theme::applyLook() {
  setFontWeights();
  QApplication::setFont(text_);
  QApplication::setPalette(PaletteOf(*this));
  qApp->setStyleSheet(styleSheet());
}

// Makes light text thinner, because on a dark background it looks bolder.
void Theme::setFontWeights() {
  const bool lighter = appearance_ == Appearance::kDark && text_.family() == kTextFamily;
  text_.setWeight(lighter ? QFont::Light : QFont::Normal);
  small_.setWeight(text_.weight());
  strong_.setWeight(lighter ? QFont::Medium : QFont::DemiBold);
}

QString Theme::styleSheet() const {
  const auto names = std::to_array<std::pair<const char*, Token>>({
      {"canvas", Token::kCanvas},
      {"panel", Token::kPanel},
      {"raised", Token::kRaised},
      {"line", Token::kLine},
      {"text", Token::kText},
      {"dim", Token::kDim},
      {"accent", Token::kAccent},
      {"onAccent", Token::kOnAccent},
      {"selection", Token::kSelection},
      {"ok", Token::kOk},
      {"warning", Token::kWarning},
      {"bad", Token::kBad},
      {"stale", Token::kStale},
  });
  QFile file(":/tendon/style.qss");
  [[maybe_unused]] const bool opened = file.open(QIODevice::ReadOnly);
  Q_ASSERT(opened);
  QString sheet = QString::fromUtf8(file.readAll());
  for (const auto& [name, token] : names) {
    sheet.replace(QStringLiteral("${%1}").arg(QLatin1String(name)), color(token).name());
  }
  return sheet.replace("${mono}", mono_.family())
      .replace("${family}", text_.family())
      .replace("${strong}", QString::number(strong_.weight()));
}

void Theme::toggle() { choose(appearance_ == Appearance::kDark ? Choice::kLight : Choice::kDark); }

void SetRole(QWidget& widget, const QString& role) {
  if (widget.property("role").toString() == role) return;
  widget.setProperty("role", role);
  widget.style()->unpolish(&widget);
  widget.style()->polish(&widget);
}

QLabel* MakeTextLine(const QString& name, const QString& role) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  SetRole(*label, role);
  return label;
}

}  // namespace tendon::gui
