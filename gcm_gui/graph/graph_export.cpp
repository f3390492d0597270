#include <gcm_gui/graph/graph_export.h>

#include <gcm_console/output/dot.h>
#include <gcm_console/output/svg.h>
#include <gcm_gui/files/file_writer.h>
#include <gcm_gui/graph/graph_hover.h>
#include <gcm_gui/graph/graph_scene.h>
#include <gcm_gui/graph/highlight.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/graph/items/process_item.h>
#include <gcm_gui/graph/layout/node_positions.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/theme.h>

#include <QBuffer>
#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QPicture>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace tendon::gui {
namespace {

constexpr double kAroundExport = 16;  // scene units
constexpr double kDots = 2;           // pixels per scene unit
// The maximum size of an image; a larger graph gets a lower resolution.
constexpr double kMaxExportPixels = 4e7;

/// The graph as recorded strokes and texts. Another thread can make an image of them.
struct Drawing {
  QPicture strokes;
  QSize size;  // pixels
};

Drawing DrawingOf(GraphScene& scene) {
  const QRectF all =
      scene.contents().adjusted(-kAroundExport, -kAroundExport, kAroundExport, kAroundExport);
  const double most = std::sqrt(kMaxExportPixels / (all.width() * all.height()));
  Drawing drawing;
  drawing.size = (all.size() * std::min(kDots, most)).toSize().expandedTo({1, 1});
  scene.hover().pointNow({});
  scene.highlight().lift(true);
  QPainter painter(&drawing.strokes);
  scene.render(&painter, QRectF({}, drawing.size), all);
  painter.end();
  scene.highlight().lift(false);
  return drawing;
}

/// Returns the positions in the window; empty if the user has not moved any component.
console::Places PlacesIn(const GraphScene& scene) {
  const auto& by_hand = scene.nodePositions().all();
  const auto& components = scene.components();
  const bool any = std::any_of(by_hand.begin(), by_hand.end(),
                               [&](const auto& place) { return components.contains(place.first); });
  if (!any) return {};
  console::Places places;
  const auto put = [&](const QString& name, const QRectF& rect) {
    places[name.toStdString()] = {rect.x(), rect.y(), rect.width(), rect.height()};
  };
  for (const auto& [name, item] : scene.processes()) put(name, item->sceneBoundingRect());
  for (const auto& [path, item] : components) put(path, item->sceneRect());
  return places;
}

QImage ImageOf(const Drawing& drawing, const QColor& ground) {
  QImage image(drawing.size, QImage::Format_RGB32);
  image.fill(ground);
  QPainter painter(&image);
  painter.drawPicture(0, 0, drawing.strokes);
  return image;
}

QByteArray PngOf(const QImage& image) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return buffer.data();
}

}  // namespace

GraphExport::GraphExport(const CatalogueStore& store, GraphScene& scene, QWidget& window)
    : QObject(&window),
      store_(store),
      scene_(scene),
      window_(window),
      poster_(std::make_shared<GuiPoster>(this)) {}

GraphExport::~GraphExport() { poster_->detach(); }

void GraphExport::ask() {
  auto* dialog = new QFileDialog(&window_, Words::tr("Save a picture of the graph"));
  dialog->setObjectName(QStringLiteral("graphExport"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilters({Words::tr("SVG, scalable (*.svg)"),
                          Words::tr("PNG, as on the screen (*.png)"),
                          Words::tr("DOT, for Graphviz (*.dot)")});
  dialog->setDefaultSuffix(QStringLiteral("svg"));
  connect(dialog, &QFileDialog::filterSelected, dialog,
          [dialog](const QString& filter) { dialog->setDefaultSuffix(filter.left(3).toLower()); });
  dialog->selectFile(QStringLiteral("system.svg"));
  connect(dialog, &QFileDialog::fileSelected, this, &GraphExport::save);
  dialog->open();
}

void GraphExport::save(const QString& file) {
  const QString kind = QFileInfo(file).suffix().toLower();
  const Catalogue& catalogue = store_.catalogue();
  if (kind == QStringLiteral("svg")) {
    return write(file, [catalogue, places = PlacesIn(scene_)] {
      std::ostringstream text;
      console::PrintSvg(console::DiagramOf(catalogue, places), text);
      return QByteArray::fromStdString(text.str());
    });
  }
  if (kind == QStringLiteral("dot") || kind == QStringLiteral("gv")) {
    return write(file, [catalogue, places = PlacesIn(scene_)] {
      std::ostringstream text;
      if (places.empty()) {
        console::PrintDot(catalogue, text);
      } else {
        console::PrintDot(catalogue, console::DiagramOf(catalogue, places), text);
      }
      return QByteArray::fromStdString(text.str());
    });
  }
  if (kind == QStringLiteral("png")) {
    return write(file,
                 [drawing = DrawingOf(scene_), ground = Theme::instance().color(Token::kCanvas)] {
                   return PngOf(ImageOf(drawing, ground));
                 });
  }
  Q_EMIT notice(
      NotSaved(file, Words::tr("end the file name with .svg, .png or .dot to choose the format")));
}

void GraphExport::write(const QString& name, Draw draw) {
  const auto fill = [draw = std::move(draw)](QIODevice& file) {
    const QByteArray content = draw();
    return file.write(content) == content.size();
  };
  FileWriter::exports().write(name, fill, this, [this, name](const QString& refusal) {
    Q_EMIT notice(refusal.isEmpty() ? name + Words::tr(" saved") : NotSaved(name, refusal));
  });
}

void GraphExport::copy() {
  thread_.start([this, poster = poster_, drawing = DrawingOf(scene_),
                 ground = Theme::instance().color(Token::kCanvas)] {
    poster->post([this, image = ImageOf(drawing, ground)] {
      QGuiApplication::clipboard()->setImage(image);
      Q_EMIT notice(Words::tr("The picture of the graph is in the clipboard"));
    });
  });
}

}  // namespace tendon::gui
