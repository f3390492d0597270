#pragma once

#include <gcm_gui/models/catalogue_filter.h>
#include <gcm_gui/models/selection.h>
#include <gcm_gui/session/signal_source.h>
#include <gcm_gui/views/row_view.h>

#include <QHash>
#include <QSet>
#include <QString>
#include <QTimer>
#include <optional>

namespace tendon::gui {

class CatalogueColumns;

/// Shows the catalogue as a tree. Expansion and selection are stored by path, so they are restored
/// when an object returns. A row that the user expands while a filter is set stays expanded after
/// the filter. A row that the user collapses while a filter is set is expanded again after the
/// filter. Live values are requested only for visible rows.
class CatalogueTree : public RowView {
  Q_OBJECT

 public:
  CatalogueTree(CatalogueFilter& filter, Selection& selection, SignalSource& source,
                QWidget* parent = nullptr);

  [[nodiscard]] CatalogueColumns& columns() const { return *columns_; }
  /// Returns the rectangles of all visible rows by path, in viewport coordinates.
  [[nodiscard]] QHash<QString, QRect> visibleRows() const;

 public Q_SLOTS:
  /// Expands the parents of the row, and scrolls to the row.
  void reveal(const QString& path);

 Q_SIGNALS:
  void plotRequested(const QString& path);
  void connectRequested(const QString& path);
  /// Emitted when the user wants the context menu of the selection at this position of the screen.
  void menuRequested(const QPoint& place);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void scrollContentsBy(int dx, int dy) override;

 private:
  /// The expanded rows, by path.
  struct ExpandedRows {
    QSet<QString> expanded;
    QSet<QString> collapsed;  // collapsed processes; processes are expanded by default

    void note(const QString& path, bool open);
  };

  void connectModel();
  void remember(const QModelIndex& index, bool open);
  /// Restores the expansion of these rows and of all rows below them.
  void restore(const QModelIndex& parent, int first, int last);
  void applyFilter();
  void activateRow(const QModelIndex& index);
  void publishSelection();
  void showSelection();
  void watchVisible();

  CatalogueFilter& filter_;
  Selection& selection_;
  SignalSource& source_;
  CatalogueColumns* columns_ = nullptr;
  ExpandedRows own_;
  std::optional<ExpandedRows> filtered_;  // the expansion while a filter is set
  QTimer settle_;
  bool restoring_ = false;
  bool publishing_ = false;
  bool removing_ = false;
};

}  // namespace tendon::gui
