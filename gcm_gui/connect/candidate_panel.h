#pragma once

#include <gcm_gui/connect/candidates_model.h>

#include <QStringList>
#include <QWidget>
#include <optional>

class QLabel;
class QLineEdit;

namespace tendon::gui {

class CandidateList;
class HeadRow;

/// The right column while a connection is made: the candidates, best first, and a field that
/// narrows them. Enter or a click picks, a digit too, Escape leaves.
class CandidatePanel : public QWidget {
  Q_OBJECT

 public:
  explicit CandidatePanel(ConnectMode& mode, QWidget* parent = nullptr);

  [[nodiscard]] QLineEdit& filterField() const { return *field_; }
  [[nodiscard]] CandidateList& list() const { return *list_; }

 public Q_SLOTS:
  void focusFilter();
  /// Below the candidates: why one that is pointed at elsewhere does not fit; nothing without a
  /// title.
  void showRefusal(const QString& title, const QStringList& reasons);

 Q_SIGNALS:
  /// The candidate that the list stands on or that the pointer is over; nothing when it does not
  /// fit, as the list says why.
  void pointed(const std::optional<tendon::gui::PortName>& port);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showMode();
  bool press(int key);
  void point(const QModelIndex& index);
  void pick(const QModelIndex& index);

  ConnectMode& mode_;
  CandidatesModel model_;
  HeadRow* head_;
  QLabel* about_;
  QLineEdit* field_;
  CandidateList* list_;
  QLabel* refusal_;
  std::optional<PortName> shown_;
};

}  // namespace tendon::gui
