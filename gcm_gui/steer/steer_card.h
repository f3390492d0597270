#pragma once

#include <gcm_gui/steer/steer_words.h>
#include <gcm_gui/views/overlay_card.h>
#include <tendon/base/path.h>

#include <vector>

class QLabel;

namespace tendon::gui {

class HoldButton;

/// Asks for confirmation before components are started or stopped: hold the button, or press Enter.
class SteerCard : public OverlayCard {
  Q_OBJECT

 public:
  /// Appears over `place`, a part of the window.
  explicit SteerCard(QWidget& place);

  /// `lines` name the components; `effects` say what will happen to them.
  void ask(LifeVerb verb, const std::vector<Path>& components, const QStringList& lines,
           const QStringList& effects);

 Q_SIGNALS:
  void confirmed(tendon::LifeVerb verb, const std::vector<tendon::Path>& components);

 protected:
  void enter() override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  LifeVerb verb_ = LifeVerb::kStart;
  std::vector<Path> components_;
  QLabel* names_;
  QLabel* advice_;
  HoldButton* button_;
};

}  // namespace tendon::gui
