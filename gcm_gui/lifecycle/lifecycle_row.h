#pragma once

#include <gcm_gui/lifecycle/lifecycle_words.h>
#include <tendon/gcm/catalogue.h>

#include <QWidget>
#include <array>
#include <string>

namespace tendon::gui {

class HoldButton;

/// The buttons to start, suspend, stop and restart one component. Each must be held for a while,
/// because any of them can cause or end a motion.
class LifecycleRow : public QWidget {
  Q_OBJECT

 public:
  explicit LifecycleRow(QWidget* parent = nullptr);

  /// Disables the buttons that the component would refuse in its state; their tool tips say why.
  void show(const Catalogue& catalogue, const std::string& process, const std::string& component);

 Q_SIGNALS:
  void chosen(tendon::LifecycleVerb verb);
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  std::array<HoldButton*, kLifecycleVerbs.size()> buttons_{};
};

}  // namespace tendon::gui
