#pragma once

#include <gcm_gui/lifecycle/lifecycle_words.h>
#include <tendon/gcm/catalogue.h>

#include <QWidget>
#include <array>
#include <string>

namespace tendon::gui {

class HoldButton;

/// The buttons to start, suspend, stop and restart one component. Each button must be held down for
/// a while, because any of these verbs can cause or end a motion.
class LifecycleRow : public QWidget {
  Q_OBJECT

 public:
  explicit LifecycleRow(QWidget* parent = nullptr);

  /// Shows a component. Disables the buttons that the component would refuse in its present state;
  /// their tool tips say why.
  void show(const Catalogue& catalogue, const std::string& process, const std::string& component);

 Q_SIGNALS:
  void chosen(tendon::LifecycleVerb verb);
  /// Emitted with one sentence for the user.
  void notice(const QString& text);

 private:
  std::array<HoldButton*, kLifecycleVerbs.size()> buttons_{};
};

}  // namespace tendon::gui
