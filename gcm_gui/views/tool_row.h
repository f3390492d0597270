#pragma once

#include <QString>
#include <QWidget>
#include <initializer_list>

class QLabel;

namespace tendon::gui {

/// Makes a row of tools above a list: `left` at the left, its last tool as wide as possible, and
/// `right` at the right edge. Takes ownership.
[[nodiscard]] QWidget* MakeToolRow(std::initializer_list<QWidget*> left,
                                   std::initializer_list<QWidget*> right);

/// Makes a dim remark for such a row.
[[nodiscard]] QLabel* MakeNote(const QString& name);

}  // namespace tendon::gui
