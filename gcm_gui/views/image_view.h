#pragma once

#include <gcm_gui/files/gui_poster.h>
#include <gcm_gui/views/raw_image.h>

#include <QImage>
#include <QWidget>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

class QLabel;

namespace tendon::gui {

/// Shows a picture as large as possible, with a caption. If there is no picture, shows the reason.
/// Pictures are prepared in another thread. If several pictures wait, only the newest one is
/// prepared.
class ImageView : public QWidget {
  Q_OBJECT

 public:
  using Source = std::function<std::optional<RawImage>()>;

  /// `name` is shown before the size in the caption; it may be empty.
  explicit ImageView(const QString& name, QWidget* parent = nullptr);
  ~ImageView() override;

  void show(RawImage picture);
  /// Calls `source` in another thread and shows the returned picture. If `source` returns none, the
  /// view is hidden.
  void showFrom(Source source);
  void clear();
  /// Draws the picture faint, with `words` below it. With empty `words`, the picture counts as
  /// live.
  void setOld(const QString& words);
  /// The picture that is shown; null if there is none.
  [[nodiscard]] const QImage& image() const { return image_; }
  [[nodiscard]] QString words() const;

 Q_SIGNALS:
  /// Emitted when the picture that was requested last is shown, or does not exist.
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
  /// Converts a picture to an image with a caption. Any thread may call it.
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
  std::uint64_t version_ = 0;  // incremented by clear(); pictures of an earlier version are dropped
  std::shared_ptr<GuiPoster> poster_;
};

}  // namespace tendon::gui
