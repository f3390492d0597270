#pragma once

#include <gcm_gui/diagnosis/diagnosis_report.h>
#include <gcm_gui/diagnosis/signature_model.h>
#include <gcm_gui/views/overlay_card.h>

class QLabel;
class QPushButton;

namespace tendon::gui {

class StepList;

/// Explains why a connection works or does not work.
class DiagnosisCard : public OverlayCard {
  Q_OBJECT

 public:
  explicit DiagnosisCard(QWidget& place);

  /// Called when the check begins: shows the two interfaces, but no steps yet.
  void begin(const message::ConnectionEnds& ends);
  /// Shows the result of the check. `required` or `provided` is null if that interface does not
  /// exist.
  void show(const DiagnosisReport& report, const RequiredDescription* required,
            const ProvidedDescription* provided);
  /// Shows only this sentence.
  void showMessage(const QString& sentence);

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
  DiagnosisReport report_;
};

}  // namespace tendon::gui
