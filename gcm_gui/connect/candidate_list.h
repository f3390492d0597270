#pragma once

#include <gcm_gui/connect/candidates_model.h>
#include <gcm_gui/views/row_view.h>

namespace tendon::gui {

/// The list of candidates. The reasons are wrapped, so that they are visible in full.
class CandidateList : public RowView {
  Q_OBJECT

 public:
  explicit CandidateList(CandidatesModel& model, QWidget* parent = nullptr);

 protected:
  void resizeEvent(QResizeEvent* event) override;
};

}  // namespace tendon::gui
