#include <gcm_gui/plot/picture/plot_picture.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/theme/theme.h>
#include <qwt_plot_canvas.h>

#include <QClipboard>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QPixmap>
#include <QSaveFile>
#include <QSvgGenerator>

namespace tendon::gui {
namespace {

constexpr int kScale = 2;

bool WriteSvg(PlotView& view, QIODevice& device) {
  QSvgGenerator generator;
  generator.setOutputDevice(&device);
  generator.setSize(view.size());
  generator.setViewBox(view.rect());
  generator.setTitle(view.accessibleName());
  auto& canvas = static_cast<QwtPlotCanvas&>(*view.canvas());
  canvas.setPaintAttribute(QwtPlotCanvas::BackingStore, false);  // which is an image
  QPainter painter(&generator);
  painter.fillRect(view.rect(), Theme::instance().color(Token::kPanel));
  view.render(&painter);
  canvas.setPaintAttribute(QwtPlotCanvas::BackingStore, true);
  return painter.end();
}

bool WriteImage(PlotView& view, QIODevice& device) {
  QImage image(view.size() * kScale, QImage::Format_RGB32);
  image.setDevicePixelRatio(kScale);
  image.fill(Theme::instance().color(Token::kPanel));
  view.render(&image);
  return image.save(&device, "PNG");
}

}  // namespace

void CopyPicture(PlotView& view) { QGuiApplication::clipboard()->setPixmap(view.grab()); }

QString SavePicture(PlotView& view, const QString& name) {
  QSaveFile file(name);
  const bool is_svg = name.endsWith(".svg", Qt::CaseInsensitive);
  const bool is_written =
      file.open(QIODevice::WriteOnly) && (is_svg ? WriteSvg(view, file) : WriteImage(view, file));
  if (is_written && file.commit()) return name + " saved";
  return name + " was not saved: " + file.errorString();
}

}  // namespace tendon::gui
