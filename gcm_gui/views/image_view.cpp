#include <gcm_gui/views/image_view.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QLabel>
#include <QPainter>
#include <QThreadPool>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace tendon::gui {
namespace {

constexpr int kMaxHeight = 240;
constexpr double kOldOpacity = 0.45;
// The maximum width and height in pixels; a larger picture is scaled down before it is stored.
constexpr int kMaxKept = 1920;

QString Caption(const QString& name, const RawImage& picture) {
  const QString size =
      QStringLiteral("%1 × %2 %3").arg(picture.width).arg(picture.height).arg(picture.encoding);
  return name.isEmpty() ? size : name + QStringLiteral(" · ") + size;
}

}  // namespace

ImageView::ImageView(const QString& name, QWidget* parent)
    : QWidget(parent), name_(name), words_(new QLabel), poster_(std::make_shared<GuiPoster>(this)) {
  setObjectName(QStringLiteral("picture"));
  words_->setObjectName(QStringLiteral("picture.words"));
  words_->setTextFormat(Qt::PlainText);
  words_->setWordWrap(true);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  SetRole(*words_, QStringLiteral("dim"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kInset, kGrid, kInset, 2 * kGrid);
  column->addStretch();
  column->addWidget(words_);
  hide();
}

ImageView::~ImageView() { poster_->detach(); }

QString ImageView::words() const { return words_->text(); }

void ImageView::show(RawImage picture) {
  showFrom([picture = std::move(picture)] { return std::optional(picture); });
}

void ImageView::showFrom(Source source) {
  next_ = std::move(source);
  if (!is_busy_) begin();
}

void ImageView::clear() {
  ++version_;
  next_ = {};
  take(std::nullopt);
}

std::optional<ImageView::PreparedImage> ImageView::Prepare(const std::optional<RawImage>& picture,
                                                           const QString& name) {
  if (!picture) return std::nullopt;
  auto image = Draw(*picture);
  if (!image) return PreparedImage{{}, QString::fromStdString(image.error().message)};
  if (std::max(image->width(), image->height()) > kMaxKept) {
    *image = image->scaled(kMaxKept, kMaxKept, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  }
  return PreparedImage{*image, Caption(name, *picture)};
}

void ImageView::begin() {
  is_busy_ = true;
  QThreadPool::globalInstance()->start([this, poster = poster_, name = name_, version = version_,
                                        source = std::exchange(next_, {})] {
    std::optional<PreparedImage> shown;
    try {
      shown = Prepare(source(), name);
    } catch (...) {
      shown = PreparedImage{{}, CurrentExceptionText()};
    }
    poster->post([this, shown, version] {
      is_busy_ = false;
      if (version == version_) {
        take(shown);
        Q_EMIT this->shown();
      }
      if (next_) begin();
    });
  });
}

void ImageView::take(const std::optional<PreparedImage>& shown) {
  image_ = shown ? shown->image : QImage();
  caption_ = shown ? shown->words : QString();
  showWords();
  SetRole(*words_, image_.isNull() ? QStringLiteral("warning") : QStringLiteral("dim"));
  setVisible(shown.has_value());
  fit();
}

void ImageView::setOld(const QString& words) {
  if (words == old_) return;
  old_ = words;
  showWords();
  update();
}

void ImageView::showWords() {
  words_->setText(old_.isEmpty() || caption_.isEmpty() ? caption_
                                                       : caption_ + QStringLiteral(" · ") + old_);
  setAccessibleName(image_.isNull() ? words_->text() : Words::tr("Picture, ") + words_->text());
}

/// Returns the size of the drawn picture. It is as wide as the view, but a picture is never
/// enlarged.
QSize ImageView::drawnSize() const {
  if (image_.isNull()) return {};
  const QSize room(std::max(1, width() - 2 * kInset), kMaxHeight);
  const bool is_small = image_.width() <= room.width() && image_.height() <= room.height();
  return is_small ? image_.size() : image_.size().scaled(room, Qt::KeepAspectRatio);
}

void ImageView::fit() {
  const int height = drawnSize().height();
  layout()->setContentsMargins(kInset, kGrid + (height > 0 ? height + kGrid : 0), kInset,
                               2 * kGrid);
  update();
}

void ImageView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit();
}

void ImageView::paintEvent(QPaintEvent*) {
  if (image_.isNull()) return;
  const QRect place(QPoint(kInset, kGrid), drawnSize());
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.setOpacity(old_.isEmpty() ? 1.0 : kOldOpacity);
  painter.drawImage(place, image_);
  painter.setOpacity(1.0);
  painter.setPen(Theme::instance().color(Token::kLine));
  painter.drawRect(place.adjusted(0, 0, -1, -1));
}

}  // namespace tendon::gui
