#pragma once

#include <gcm_gui/system/diff_model.h>
#include <gcm_gui/system/restore.h>
#include <gcm_gui/system/system_document.h>

#include <QString>
#include <QWidget>

class QCheckBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace tendon::gui {

class RowView;

/// The running system beside its file, line by line, and the steps from the one to the other before
/// and while they are made.
class DiffPanel : public QWidget {
  Q_OBJECT

 public:
  /// `refusal` says why nothing can be changed from this window; empty where it can.
  DiffPanel(SystemDocument& document, Restore& restore, const QString& refusal,
            QWidget* parent = nullptr);

 public Q_SLOTS:
  /// All of the file: the plan for it, to look at.
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
  Restore& restore_;
  const QString refusal_;
  Restore::Phase shown_phase_ = Restore::Phase::kIdle;
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
