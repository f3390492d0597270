#pragma once

#include <QObject>
#include <QString>

namespace tendon::gui {

/// Disables all buttons of the application with the property "changesSystem", and gives the reason
/// as their tool tip.
class ReadOnlyMode : public QObject {
  Q_OBJECT

 public:
  explicit ReadOnlyMode(QString reason, QObject* parent = nullptr);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  const QString reason_;
};

}  // namespace tendon::gui
