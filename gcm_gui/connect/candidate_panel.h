#pragma once

#include <gcm_gui/connect/candidates_model.h>

#include <QStringList>
#include <QWidget>
#include <optional>

class QLabel;
class QLineEdit;

namespace tendon::gui {

class CandidateList;
class HeaderRow;

/// The right column while the user makes a connection: the candidates, best first, and a filter.
/// Enter, a click or a digit picks a candidate; Escape ends the connect mode.
class CandidatePanel : public QWidget {
  Q_OBJECT

 public:
  explicit CandidatePanel(ConnectMode& mode, QWidget* parent = nullptr);

  [[nodiscard]] QLineEdit& filterField() const { return *field_; }
  [[nodiscard]] CandidateList& list() const { return *list_; }

 public Q_SLOTS:
  void focusFilter();
  /// Called when a port under the pointer in another view does not fit: shows the reasons below the
  /// candidates. An empty title hides them.
  void showRefusal(const QString& title, const QStringList& reasons);

 Q_SIGNALS:
  /// Emitted with the current candidate of the list or the candidate under the pointer. Empty if
  /// this candidate does not fit, because the list already shows the reasons.
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
  HeaderRow* head_;
  QLabel* about_;
  QLineEdit* field_;
  CandidateList* list_;
  QLabel* refusal_;
  std::optional<PortName> shown_;
};

}  // namespace tendon::gui
