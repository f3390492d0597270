#pragma once

#include <gcm_gui/inspector/values_model.h>
#include <gcm_gui/models/selection.h>
#include <gcm_gui/session/signal_source.h>

#include <QModelIndex>
#include <QString>
#include <QTimer>
#include <QWidget>

namespace tendon::gui {

class ImageList;
class RowView;

/// Shows the live values of one component, and its pictures below them.
class ValuesPage : public QWidget {
  Q_OBJECT

 public:
  ValuesPage(Selection& selection, SignalSource& source, QWidget* parent = nullptr);

  /// Shows the component with this path. If it does not run, `why` says why its values are old.
  void showComponent(const QString& path, const ComponentDescription& component, StaleReason why);
  /// Starts or stops the live values. Pass true while the page is visible.
  void setWanted(bool wanted);

 Q_SIGNALS:
  void plotRequested(const QString& path, const QString& unit);

 private:
  void askAgain(const QModelIndex& index);
  void publishSelection();

  Selection& selection_;
  SignalSource& source_;
  ValuesModel values_;
  QTimer tick_;
  RowView* list_;
  ImageList* pictures_;
};

}  // namespace tendon::gui
