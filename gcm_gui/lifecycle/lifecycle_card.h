#pragma once

#include <gcm_gui/lifecycle/lifecycle_words.h>
#include <gcm_gui/views/overlay_card.h>
#include <tendon/base/path.h>

#include <vector>

class QLabel;

namespace tendon::gui {

class HoldButton;

/// Asks for confirmation before components are started or stopped. The user confirms by holding the
/// button or by pressing Enter.
class LifecycleCard : public OverlayCard {
  Q_OBJECT

 public:
  /// Appears over `place`, a part of the window.
  explicit LifecycleCard(QWidget& place);

  /// Opens the card. `lines` name the components; `effects` say what will happen to them.
  void ask(LifecycleVerb verb, const std::vector<Path>& components, const QStringList& lines,
           const QStringList& effects);

 Q_SIGNALS:
  void confirmed(tendon::LifecycleVerb verb, const std::vector<tendon::Path>& components);

 protected:
  void enter() override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  LifecycleVerb verb_ = LifecycleVerb::kStart;
  std::vector<Path> components_;
  QLabel* names_;
  QLabel* advice_;
  HoldButton* button_;
};

}  // namespace tendon::gui
