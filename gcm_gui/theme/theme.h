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

  /// The theme of this QApplication, which owns it. The first call applies it to the application.
  static Theme& instance();

  [[nodiscard]] Choice choice() const { return choice_; }
  /// Takes effect at once, also in open windows.
  void choose(Choice choice);
  /// Switches between dark and light.
  void toggle();
  [[nodiscard]] Appearance appearance() const { return appearance_; }

  [[nodiscard]] QColor color(Token token) const { return ColorOf(token, appearance_); }
  /// `opacity` from 0 to 1.
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

/// Sets the style sheet roles of a label or a tool button: "dim", "strong", "mono", "ok",
/// "warning", "bad", "accent", several with blanks between; "" for none. A push button may be
/// "primary".
void SetRole(QWidget& widget, const QString& role);

/// An empty label for plain text that wraps, with this style role; the caller owns it.
[[nodiscard]] QLabel* MakeTextLine(const QString& name, const QString& role);

}  // namespace tendon::gui
