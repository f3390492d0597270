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

/// The seven steps, one below the other: a mark, the number, what was found; below a bad one its
/// details and what to do, to be copied; below the signatures both sides, when that is wanted.
class StepList : public QWidget {
  Q_OBJECT

 public:
  explicit StepList(SignatureModel& signatures, QWidget* parent = nullptr);

  void show(const Diagnosis& diagnosis);
  /// Of two interfaces that are both there; else there is nothing to set side by side. Before
  /// show().
  void setComparable(bool comparable) { comparable_ = comparable; }
  /// The keys reach what is in it behind `before`.
  void orderTabs(QWidget& before);

 Q_SIGNALS:
  /// One sentence: what has been copied.
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
  bool compares_ = false;  // what is shown
};

}  // namespace tendon::gui
