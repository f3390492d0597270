#pragma once

#include <tendon/gcm/diagnosis.h>

#include <QWidget>
#include <vector>

class QGridLayout;
class QLabel;
class QToolButton;

namespace tendon::gui {

class RowView;
class SignatureModel;

/// Lists the seven steps of a check, each with a mark, a number and a finding. Below a failed step,
/// it shows details and remedies, which the user can copy. Below the step that compares the
/// signatures, the user can open a comparison of both interfaces.
class StepList : public QWidget {
  Q_OBJECT

 public:
  explicit StepList(SignatureModel& signatures, QWidget* parent = nullptr);

  void show(const Diagnosis& diagnosis);
  /// True if both interfaces exist, so that they can be shown side by side. Call it before show().
  void setComparable(bool comparable) { comparable_ = comparable; }
  /// Puts the list after `before` in the tab order.
  void orderTabs(QWidget& before);

 Q_SIGNALS:
  /// Emitted with one sentence about the copied text.
  void copied(const QString& text);

 private:
  void addStep(int number, const DiagnosisStep& step);
  void addFix(const DiagnosisStep& step);
  void addSides();
  void showSides(bool shown);
  [[nodiscard]] QLabel* addText(const QString& text, const QString& role);

  RowView* sides_;
  QToolButton* toggle_ = nullptr;
  QGridLayout* grid_ = nullptr;
  QWidget* rows_ = nullptr;
  std::vector<DiagnosisStep> shown_;
  bool comparable_ = false;
  bool compares_ = false;  // true while the comparison is visible
};

}  // namespace tendon::gui
