#include <gcm_gui/views/image_list.h>

#include <gcm_gui/views/image_view.h>

#include <QVBoxLayout>

namespace tendon::gui {

ImageList::ImageList(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("pictures"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  hide();
}

void ImageList::setColumns(const QSet<QString>& columns) {
  columns_ = columns;
  for (auto view = views_.begin(); view != views_.end();) {
    if (columns.contains(view.key())) {
      ++view;
      continue;
    }
    delete view.value();
    view = views_.erase(view);
  }
  setVisible(!views_.isEmpty());
}

void ImageList::setStandstill(StaleReason why) {
  still_ = WordOf(why);
  for (ImageView* view : views_) view->setOld(still_);
}

void ImageList::showValues(const QString& column, const ColumnValues& values) {
  if (values.picture == nullptr || !columns_.contains(column)) return;
  ImageView*& view = views_[column];
  if (view == nullptr) {
    view = new ImageView(column.section('.', -1));
    layout()->addWidget(view);
    view->setOld(still_);
    show();
  }
  view->show(*values.picture);
}

}  // namespace tendon::gui
