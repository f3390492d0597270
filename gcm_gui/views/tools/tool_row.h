#pragma once

#include <QString>
#include <QWidget>
#include <initializer_list>

class QLabel;

namespace tendon::gui {

/// A row of tools above a list: the first at the left, the last of them as wide as there is room;
/// the second at the right edge. Takes ownership.
[[nodiscard]] QWidget* MakeToolRow(std::initializer_list<QWidget*> left,
                                   std::initializer_list<QWidget*> right);

/// A dim remark in such a row.
[[nodiscard]] QLabel* MakeNote(const QString& name);

}  // namespace tendon::gui
