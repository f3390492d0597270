#pragma once

#include <gcm_gui/models/catalogue_model.h>
#include <gcm_gui/models/row_list_model.h>

#include <QList>
#include <QString>

class QAction;

namespace tendon::gui {

/// Something that can be done, or a thing of the catalogue to go to.
struct PaletteRow {
  QAction* action = nullptr;
  QString text;   ///< of a thing its path
  QString trail;  ///< the key, or what kind of thing it is

  bool operator==(const PaletteRow&) const = default;
};

/// What fits some typed words: commands first, then the things whose name fits best. Only where
/// nothing has the words themselves, what has their letters in their order, with few others
/// between. Without words all commands.
class PaletteModel : public RowListModel<PaletteRow> {
  Q_OBJECT

 public:
  static constexpr std::size_t kMostThings = 50;

  PaletteModel(QList<QAction*> actions, const CatalogueModel& catalogue, QObject* parent = nullptr);

  /// Whatever the case. Finds things as they are now.
  void find(const QString& words);

  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

 private:
  QList<QAction*> actions_;
  const CatalogueModel& catalogue_;
};

}  // namespace tendon::gui
