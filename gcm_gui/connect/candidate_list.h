#pragma once

#include <gcm_gui/connect/candidates_model.h>
#include <gcm_gui/views/row_view.h>

namespace tendon::gui {

/// The list of candidates; wraps reasons, so that they are fully visible.
class CandidateList : public RowView {
  Q_OBJECT

 public:
  explicit CandidateList(CandidatesModel& model, QWidget* parent = nullptr);

 protected:
  void resizeEvent(QResizeEvent* event) override;
};

}  // namespace tendon::gui
