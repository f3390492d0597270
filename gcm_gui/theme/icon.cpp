#include <gcm_gui/theme/icon.h>

#include <gcm_gui/theme/theme.h>

#include <QFile>
#include <QHash>
#include <QIconEngine>
#include <QPainter>
#include <QPixmap>
#include <QSvgRenderer>
#include <memory>
#include <utility>

namespace tendon::gui {
namespace {

// Returns the parsed drawing of this name and colour. There are only a few drawings, so all of them
// are cached.
QSvgRenderer& Drawing(const QString& name, const QColor& color) {
  static QHash<std::pair<QString, QRgb>, std::shared_ptr<QSvgRenderer>> drawings;
  auto& drawing = drawings[{name, color.rgb()}];
  if (drawing == nullptr) {
    QFile file(":/tendon/icons/" + name + ".svg");
    [[maybe_unused]] const bool opened = file.open(QIODevice::ReadOnly);
    Q_ASSERT_X(opened, "ThemeIcon", qPrintable(name));
    QByteArray svg = file.readAll();
    drawing = std::make_shared<QSvgRenderer>(svg.replace("currentColor", color.name().toLatin1()));
  }
  return *drawing;
}

class ThemeIconEngine final : public QIconEngine {
 public:
  ThemeIconEngine(QString name, Token token) : name_(std::move(name)), token_(token) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    PaintIcon(*painter, rect, name_, mode == QIcon::Disabled ? Token::kStale : token_);
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, {{}, size}, mode, state);
    return pixmap;
  }

  [[nodiscard]] QIconEngine* clone() const override { return new ThemeIconEngine(name_, token_); }

 private:
  QString name_;
  Token token_;
};

}  // namespace

QIcon ThemeIcon(const QString& name, Token token) {
  return QIcon(new ThemeIconEngine(name, token));
}

void PaintIcon(QPainter& painter, const QRectF& rect, const QString& name, Token token) {
  Drawing(name, Theme::instance().color(token)).render(&painter, rect);
}

}  // namespace tendon::gui
