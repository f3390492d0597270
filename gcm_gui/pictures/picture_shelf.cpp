#include <gcm_gui/pictures/picture_shelf.h>
#include <gcm_gui/pictures/picture_view.h>

#include <QVBoxLayout>

namespace tendon::gui {

PictureShelf::PictureShelf(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("pictures"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  hide();
}

void PictureShelf::setColumns(const QSet<QString>& columns) {
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

void PictureShelf::setStandstill(StaleReason why) {
  still_ = WordOf(why);
  for (PictureView* view : views_) view->setOld(still_);
}

void PictureShelf::showValues(const QString& column, const ColumnValues& values) {
  if (values.picture == nullptr || !columns_.contains(column)) return;
  PictureView*& view = views_[column];
  if (view == nullptr) {
    view = new PictureView(column.section('.', -1));
    layout()->addWidget(view);
    view->setOld(still_);
    show();
  }
  view->show(*values.picture);
}

}  // namespace tendon::gui
