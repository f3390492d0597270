#pragma once

#include <QString>
#include <QWidget>
#include <initializer_list>

class QLabel;

namespace tendon::gui {

/// Makes a row of tools above a list. The tools of `left` are at the left, the last of them as wide
/// as possible; the tools of `right` are at the right edge. Takes ownership.
[[nodiscard]] QWidget* MakeToolRow(std::initializer_list<QWidget*> left,
                                   std::initializer_list<QWidget*> right);

/// Makes a label for a remark in dim text, for a row of tools.
[[nodiscard]] QLabel* MakeNote(const QString& name);

}  // namespace tendon::gui
