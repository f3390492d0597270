#pragma once

#include <QObject>
#include <QString>

namespace tendon::gui {

/// Keeps all buttons of the application disabled that would change the system, and says why. They
/// have the property "changesSystem".
class ReadOnly : public QObject {
  Q_OBJECT

 public:
  explicit ReadOnly(QString reason, QObject* parent = nullptr);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  const QString reason_;
};

}  // namespace tendon::gui
