#pragma once

#include <gcm_gui/steer/steer_words.h>
#include <tendon/gcm/catalog.h>

#include <QWidget>
#include <array>
#include <string>

namespace tendon::gui {

class HoldButton;

/// The buttons that start, suspend, stop and restart one component. Each is held for a while: any
/// of them can set something in motion, or let it fall.
class SteerRow : public QWidget {
  Q_OBJECT

 public:
  explicit SteerRow(QWidget* parent = nullptr);

  /// What the component would refuse in its state is disabled, and says why.
  void show(const Catalog& catalogue, const std::string& process, const std::string& component);

 Q_SIGNALS:
  void chosen(tendon::LifeVerb verb);
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  std::array<HoldButton*, kSteerVerbs.size()> buttons_{};
};

}  // namespace tendon::gui
