#pragma once

#include <QList>
#include <QString>
#include <QWidget>
#include <utility>

class QGridLayout;
class QLabel;

namespace tendon::gui {

/// A short table of facts: what it is at the left, dim; how much at the right, in tabular figures.
class FactGrid : public QWidget {
  Q_OBJECT

 public:
  using Facts = QList<std::pair<QString, QString>>;

  explicit FactGrid(QWidget* parent = nullptr);

  void show(const Facts& facts);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QGridLayout* grid_;
  QList<std::pair<QLabel*, QLabel*>> rows_;
};

}  // namespace tendon::gui
