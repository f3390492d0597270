#pragma once

#include <gcm_gui/models/filter/catalogue_filter.h>
#include <gcm_gui/models/selection.h>
#include <gcm_gui/session/signal_source.h>
#include <gcm_gui/views/row_view.h>

#include <QHash>
#include <QSet>
#include <QString>
#include <QTimer>

namespace tendon::gui {

/// The catalogue on the screen. What is expanded and what is selected is kept by path, so that both
/// come back with what they name. Live values are asked for only for rows that can be seen.
class CatalogueTree : public RowView {
  Q_OBJECT

 public:
  CatalogueTree(CatalogueFilter& filter, Selection& selection, SignalSource& source,
                QWidget* parent = nullptr);

  /// On the viewport, of every row that can be seen, by path.
  [[nodiscard]] QHash<QString, QRect> visibleRows() const;

 public Q_SLOTS:
  /// Expands what is above it and scrolls to it.
  void reveal(const QString& path);

 Q_SIGNALS:
  void plotRequested(const QString& path);
  void connectRequested(const QString& path);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void scrollContentsBy(int dx, int dy) override;

 private:
  void connectModel();
  void restore(const QModelIndex& parent, int first, int last);
  [[nodiscard]] bool wantsExpanded(const QModelIndex& index) const;
  void applyFilter();
  void activateRow(const QModelIndex& index);
  void publishSelection();
  void showSelection();
  void watchVisible();

  CatalogueFilter& filter_;
  Selection& selection_;
  SignalSource& source_;
  QSet<QString> expanded_;
  QSet<QString> collapsed_;  // processes, which are open unless closed
  QTimer settle_;
  bool restoring_ = false;
  bool publishing_ = false;
  bool removing_ = false;
};

}  // namespace tendon::gui
