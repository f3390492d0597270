#pragma once

#include <gcm_gui/why/signature_model.h>
#include <gcm_gui/why/why_report.h>

#include <QFrame>
#include <QPointer>

class QLabel;
class QPushButton;
class QScrollArea;
class QToolButton;

namespace tendon::gui {

class StepList;

/// Why a connection stands or does not, over the middle of the window; no dialog: all else goes on
/// and can be used. Escape closes it and gives the focus back.
class WhyCard : public QFrame {
  Q_OBJECT

 public:
  /// Stands over `place`, a part of its window.
  explicit WhyCard(QWidget& place);

  /// The check has begun: the ends are known, the steps are not.
  void begin(const message::Wire& wire);
  /// Null descriptions where an end is not there.
  void show(const WhyReport& report, const RequiredDescription* required,
            const ProvidedDescription* provided);
  /// Nothing can be said but this.
  void tell(const QString& sentence);
  void close();

 Q_SIGNALS:
  void retryRequested();
  void closed();
  /// One sentence for the user.
  void notice(const QString& text);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] QWidget* buildHead();
  void open();
  void fit();
  void copyReport();

  QWidget& place_;
  SignatureModel signatures_;
  QLabel* title_;
  QLabel* verdict_;
  QLabel* history_;
  StepList* steps_;
  QLabel* leftovers_;
  QScrollArea* scroll_;
  QPushButton* retry_;
  QPushButton* copy_;
  QToolButton* leave_;
  WhyReport report_;
  QPointer<QWidget> before_;  // had the focus
};

}  // namespace tendon::gui
