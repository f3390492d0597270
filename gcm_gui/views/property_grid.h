#pragma once

#include <QList>
#include <QString>
#include <QWidget>
#include <utility>

class QGridLayout;
class QLabel;

namespace tendon::gui {

struct Property {
  enum class Kind { kFigure, kSentence };

  QString name;
  QString value;
  QString help = {};  ///< explanation for the tool tip
  Kind kind = Kind::kFigure;
};

/// A short table of facts. The names are on the left in dim text. The values are on the right:
/// numbers in digits of equal width, or texts that are wrapped.
class PropertyGrid : public QWidget {
  Q_OBJECT

 public:
  explicit PropertyGrid(QWidget* parent = nullptr);

  void show(const QList<Property>& facts);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void addRow();

  QGridLayout* grid_;
  QList<std::pair<QLabel*, QLabel*>> rows_;
};

}  // namespace tendon::gui
