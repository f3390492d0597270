#pragma once

#include <gcm_gui/views/overlay_card.h>
#include <gcm_gui/why/signature_model.h>
#include <gcm_gui/why/why_report.h>

class QLabel;
class QPushButton;

namespace tendon::gui {

class StepList;

/// Why a connection stands or does not.
class WhyCard : public OverlayCard {
  Q_OBJECT

 public:
  explicit WhyCard(QWidget& place);

  /// The check has begun: the ends are known, the steps are not.
  void begin(const message::Wire& wire);
  /// Null descriptions where an end is not there.
  void show(const WhyReport& report, const RequiredDescription* required,
            const ProvidedDescription* provided);
  /// Nothing can be said but this.
  void tell(const QString& sentence);

 Q_SIGNALS:
  void retryRequested();

 private:
  void buildHead();
  void buildBody(QWidget& body);
  void copyReport();

  SignatureModel signatures_;
  QLabel* title_;
  QLabel* verdict_;
  QLabel* history_;
  StepList* steps_;
  QLabel* leftovers_;
  QPushButton* retry_;
  QPushButton* copy_;
  WhyReport report_;
};

}  // namespace tendon::gui
