// drag_source FILE: shows a small window from which the mouse drags this file, as a file manager
// does.

#include <QApplication>
#include <QDrag>
#include <QLabel>
#include <QMimeData>
#include <QMouseEvent>
#include <QString>
#include <QUrl>
#include <iostream>
#include <utility>

namespace {

class Source final : public QLabel {
 public:
  explicit Source(QString file) : QLabel(file), file_(std::move(file)) {}

 protected:
  void mousePressEvent(QMouseEvent* /*event*/) override {}
  void mouseMoveEvent(QMouseEvent* /*event*/) override {
    auto* drag = new QDrag(this);
    auto* data = new QMimeData;
    data->setUrls({QUrl::fromLocalFile(file_)});
    drag->setMimeData(data);
    drag->exec(Qt::CopyAction);
  }

 private:
  const QString file_;
};

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  if (argc != 2) {
    std::cerr << "usage: drag_source FILE\n";
    return 1;
  }
  Source source(QString::fromLocal8Bit(argv[1]));
  source.setWindowFlag(Qt::WindowStaysOnTopHint);
  source.setGeometry(40, 40, 240, 80);
  source.show();
  return QApplication::exec();
}
