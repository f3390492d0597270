#pragma once

#include <gcm_gui/pictures/raw_picture.h>
#include <gcm_gui/session/courier.h>

#include <QImage>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

class QLabel;

namespace tendon::gui {

/// A picture as large as there is room, and below it what it is; or in words why there is none. It
/// is made ready in another thread, the newest first; those that come meanwhile are left out.
class PictureView : public QWidget {
  Q_OBJECT

 public:
  using Source = std::function<std::optional<RawPicture>()>;

  /// `name` goes before the size below the picture; may be empty.
  explicit PictureView(const QString& name, QWidget* parent = nullptr);
  ~PictureView() override;

  void show(RawPicture picture);
  /// What `source`, which is called in another thread, finds; hidden where that is nothing.
  void showFrom(Source source);
  void clear();
  /// Drawn faint, with these words below it; empty for one that is live.
  void setOld(const QString& words);
  /// Null where there is none.
  [[nodiscard]] const QImage& image() const { return image_; }
  [[nodiscard]] QString words() const;

 Q_SIGNALS:
  /// What was given is there now, or is known to be none.
  void shown();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Shown {
    QImage image;
    QString words;
  };

  void begin();
  /// In any thread.
  static std::optional<Shown> Prepare(const std::optional<RawPicture>& picture,
                                      const QString& name);
  void take(const std::optional<Shown>& shown);
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
  std::uint64_t version_ = 0;  // what was begun before clear() is not shown after it
  std::shared_ptr<Courier> courier_;
};

}  // namespace tendon::gui
