#pragma once

#include <gcm_gui/files/gui_poster.h>
#include <gcm_gui/views/raw_image.h>

#include <QImage>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

class QLabel;

namespace tendon::gui {

/// Shows a picture as large as possible with a caption, or the reason why there is none. Prepares
/// pictures in another thread, the newest first, and skips older ones.
class ImageView : public QWidget {
  Q_OBJECT

 public:
  using Source = std::function<std::optional<RawImage>()>;

  /// `name` precedes the size in the caption; may be empty.
  explicit ImageView(const QString& name, QWidget* parent = nullptr);
  ~ImageView() override;

  void show(RawImage picture);
  /// Shows the result of `source`, called in another thread; hidden if it returns no picture.
  void showFrom(Source source);
  void clear();
  /// Draws the picture faint, with `words` below it; empty for a live picture.
  void setOld(const QString& words);
  /// Null if there is none.
  [[nodiscard]] const QImage& image() const { return image_; }
  [[nodiscard]] QString words() const;

 Q_SIGNALS:
  /// The last requested picture is shown now, or does not exist.
  void shown();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct PreparedImage {
    QImage image;
    QString words;
  };

  void begin();
  /// Any thread may call it.
  static std::optional<PreparedImage> Prepare(const std::optional<RawImage>& picture,
                                              const QString& name);
  void take(const std::optional<PreparedImage>& shown);
  void fit();
  void showWords();
  [[nodiscard]] QSize drawnSize() const;

  QString name_;
  QLabel* words_;
  QString caption_;
  QString old_;
  QImage image_;
  Source next_;
  bool is_busy_ = false;
  std::uint64_t version_ = 0;  // pictures begun before clear() are dropped
  std::shared_ptr<GuiPoster> poster_;
};

}  // namespace tendon::gui
