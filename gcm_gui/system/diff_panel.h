#pragma once

#include <gcm_gui/system/diff_model.h>
#include <gcm_gui/system/plan_controller.h>
#include <gcm_gui/system/system_document.h>

#include <QString>
#include <QWidget>
#include <string>

class QCheckBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace tendon::gui {

class RowView;

/// Compares the running system with its file, line by line. Before and during the execution of a
/// plan, it also shows the steps that make the system match the file.
class DiffPanel : public QWidget {
  Q_OBJECT

 public:
  /// `refusal` says why this window cannot change anything; empty if the window can change the
  /// system.
  DiffPanel(SystemDocument& document, PlanController& restore, const QString& refusal,
            QWidget* parent = nullptr);

 public Q_SLOTS:
  /// Shows the plan for the whole file without executing it.
  void previewAll();

 private:
  [[nodiscard]] QWidget* buildDiff();
  [[nodiscard]] QWidget* buildPlan();
  void previewOne();
  void updateOne();
  void showDiff();
  void showPlan();
  void choose(const std::string& what);
  void showButtons();
  void allow(QPushButton& button, bool allowed) const;
  [[nodiscard]] QString planText() const;
  [[nodiscard]] const SystemDifference* currentLine() const;

  SystemDocument& document_;
  PlanController& restore_;
  const QString refusal_;
  PlanController::Phase shown_phase_ = PlanController::Phase::kIdle;
  DiffModel differences_;
  PlanModel steps_;
  QStackedWidget* pages_;
  QLabel* summary_ = nullptr;
  RowView* diff_list_ = nullptr;
  QPushButton* apply_ = nullptr;
  QPushButton* update_ = nullptr;
  QPushButton* restore_all_ = nullptr;
  QLabel* plan_text_ = nullptr;
  RowView* step_list_ = nullptr;
  QCheckBox* go_on_ = nullptr;
  QPushButton* carry_out_ = nullptr;
  QPushButton* stop_ = nullptr;
  QPushButton* undo_ = nullptr;
  QPushButton* back_ = nullptr;
};

}  // namespace tendon::gui
