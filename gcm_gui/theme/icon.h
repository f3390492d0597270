#pragma once

#include <gcm_gui/theme/tokens.h>

#include <QIcon>
#include <QString>

class QPainter;
class QRectF;

namespace tendon::gui {

/// Returns the drawing `name` of resources/icons in a colour of the theme. The icon is sharp at
/// every scale and follows changes of the theme. A disabled icon has the colour kStale.
[[nodiscard]] QIcon ThemeIcon(const QString& name, Token token = Token::kDim);

/// Paints the icon of ThemeIcon(); used by delegates and scenes.
void PaintIcon(QPainter& painter, const QRectF& rect, const QString& name, Token token);

}  // namespace tendon::gui
