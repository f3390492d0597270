#include <gcm_gui/plot/series/row_losses.h>

#include <gcm_gui/language/words.h>

#include <QStringList>

namespace tendon::gui {

QString LossPlaces(const RowLosses& losses, const QString& in_window) {
  QStringList places;
  if (losses.table > 0) places << Words::tr("%1 in its process").arg(losses.table);
  if (losses.network > 0) places << Words::tr("%1 on the network").arg(losses.network);
  if (losses.viewer > 0) places << in_window.arg(losses.viewer);
  return places.join(QStringLiteral(", "));
}

}  // namespace tendon::gui
