#pragma once

#include <gcm_gui/theme/tokens.h>

#include <QFont>
#include <QObject>
#include <QString>

class QWidget;
class QLabel;

namespace tendon::gui {

class SystemAppearance;

/// The look of the application: style, palette, style sheet and fonts, dark or light.
///
/// A widget with its own painting must take its colours from here in each paint event, and repaint
/// on changed(). No other code sets a colour. GUI thread only.
class Theme : public QObject {
  Q_OBJECT

 public:
  enum class Choice { kSystem, kDark, kLight };

  /// Returns the theme of this QApplication, which owns it. The first call applies the theme to the
  /// application.
  static Theme& instance();

  [[nodiscard]] Choice choice() const { return choice_; }
  /// Sets dark, light or the choice of the system. Takes effect at once, in open windows too.
  void choose(Choice choice);
  /// Switches from dark to light, or from light to dark.
  void toggle();
  [[nodiscard]] Appearance appearance() const { return appearance_; }

  [[nodiscard]] QColor color(Token token) const { return ColorOf(token, appearance_); }
  /// `opacity` is from 0 to 1.
  [[nodiscard]] QColor color(Token token, double opacity) const;
  [[nodiscard]] QColor curve(int index) const { return CurveColor(index, appearance_); }

  [[nodiscard]] const QFont& text() const { return text_; }      ///< all other text
  [[nodiscard]] const QFont& strong() const { return strong_; }  ///< heads and names
  [[nodiscard]] const QFont& mono() const { return mono_; }      ///< numbers, paths, types
  [[nodiscard]] const QFont& small() const { return small_; }    ///< axes and legends
  [[nodiscard]] const QFont& smallMono() const { return small_mono_; }

 Q_SIGNALS:
  void changed();

 private:
  explicit Theme(QObject* parent);

  void follow();
  void applyLook();
  void setFontWeights();
  [[nodiscard]] QString styleSheet() const;

  SystemAppearance* system_;
  Choice choice_ = Choice::kSystem;
  Appearance appearance_;
  QFont text_;
  QFont strong_;
  QFont mono_;
  QFont small_;
  QFont small_mono_;
};

/// Sets the roles of a label or a tool button in the style sheet: "dim", "strong", "mono", "ok",
/// "warning", "bad", "accent". Several roles are separated by blanks; "" means none. A push button
/// may have the role "primary".
void SetRole(QWidget& widget, const QString& role);

/// Makes an empty label for plain text that is wrapped, with this style role. The caller owns it.
[[nodiscard]] QLabel* MakeTextLine(const QString& name, const QString& role);

}  // namespace tendon::gui
