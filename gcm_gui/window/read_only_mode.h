#pragma once

#include <QObject>
#include <QString>

namespace tendon::gui {

/// Disables all buttons of the application that have the property "changesSystem". Their tool tips
/// give the reason.
class ReadOnlyMode : public QObject {
  Q_OBJECT

 public:
  explicit ReadOnlyMode(QString reason, QObject* parent = nullptr);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  const QString reason_;
};

}  // namespace tendon::gui
