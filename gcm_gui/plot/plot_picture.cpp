#include <gcm_gui/plot/plot_picture.h>

#include <gcm_gui/files/file_writer.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/theme/theme.h>
#include <qwt_plot_canvas.h>

#include <QBuffer>
#include <QClipboard>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QPixmap>
#include <QSvgGenerator>

namespace tendon::gui {
namespace {

constexpr int kScale = 2;

QByteArray SvgOf(PlotView& view) {
  QBuffer buffer;
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setSize(view.size());
  generator.setViewBox(view.rect());
  generator.setTitle(view.accessibleName());
  auto& canvas = static_cast<QwtPlotCanvas&>(*view.canvas());
  // The backing store is an image, which is not scalable.
  canvas.setPaintAttribute(QwtPlotCanvas::BackingStore, false);
  QPainter painter(&generator);
  painter.fillRect(view.rect(), Theme::instance().color(Token::kPanel));
  view.render(&painter);
  canvas.setPaintAttribute(QwtPlotCanvas::BackingStore, true);
  painter.end();
  return buffer.data();
}

QImage ImageOf(PlotView& view) {
  QImage image(view.size() * kScale, QImage::Format_RGB32);
  image.setDevicePixelRatio(kScale);
  image.fill(Theme::instance().color(Token::kPanel));
  view.render(&image);
  return image;
}

}  // namespace

void CopyPicture(PlotView& view) { QGuiApplication::clipboard()->setPixmap(view.grab()); }

void SavePicture(PlotView& view, const QString& name, const QObject* context,
                 const std::function<void(const QString& sentence)>& report) {
  const auto done = [name, report](const QString& refusal) {
    report(refusal.isEmpty() ? name + Words::tr(" saved") : NotSaved(name, refusal));
  };
  FileWriter& writer = FileWriter::exports();
  if (name.endsWith(".svg", Qt::CaseInsensitive)) {
    return writer.write(name, SvgOf(view), context, done);
  }
  writer.write(
      name, [image = ImageOf(view)](QIODevice& file) { return image.save(&file, "PNG"); }, context,
      done);
}

}  // namespace tendon::gui
