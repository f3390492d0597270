#pragma once

#include <gcm_gui/models/filter/catalogue_filter.h>
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

/// The catalogue on the screen. What is expanded and what is selected is kept by path, so that both
/// come back with what they name. What is opened while there is a filter stays open without it;
/// what is closed meanwhile is closed only until then. Live values are asked for only for rows that
/// can be seen.
class CatalogueTree : public RowView {
  Q_OBJECT

 public:
  CatalogueTree(CatalogueFilter& filter, Selection& selection, SignalSource& source,
                QWidget* parent = nullptr);

  [[nodiscard]] CatalogueColumns& columns() const { return *columns_; }
  /// On the viewport, of every row that can be seen, by path.
  [[nodiscard]] QHash<QString, QRect> visibleRows() const;

 public Q_SLOTS:
  /// Expands what is above it and scrolls to it.
  void reveal(const QString& path);

 Q_SIGNALS:
  void plotRequested(const QString& path);
  void connectRequested(const QString& path);
  /// Of what is selected, at a place on the screen.
  void menuRequested(const QPoint& place);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void scrollContentsBy(int dx, int dy) override;

 private:
  /// Which rows are open, by path.
  struct Open {
    QSet<QString> expanded;
    QSet<QString> collapsed;  // processes, which are open unless closed

    void note(const QString& path, bool open);
  };

  void connectModel();
  void remember(const QModelIndex& index, bool open);
  /// Expands, of these rows and all below them, those that were.
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
  Open own_;
  std::optional<Open> filtered_;  // while there is a filter
  QTimer settle_;
  bool restoring_ = false;
  bool publishing_ = false;
  bool removing_ = false;
};

}  // namespace tendon::gui
