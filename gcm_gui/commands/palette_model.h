#pragma once

#include <gcm_gui/models/catalogue_model.h>
#include <gcm_gui/models/row_list_model.h>

#include <QList>
#include <QString>

class QAction;

namespace tendon::gui {

/// A command, or an object of the catalogue to go to.
struct PaletteRow {
  QAction* action = nullptr;
  QString text;   ///< for an object its path
  QString trail;  ///< the key, or the kind of object

  bool operator==(const PaletteRow&) const = default;
};

/// The matches of some typed words: commands first, then objects, best match first. If nothing
/// contains the words, matches their letters in order, with few letters in between. Without words,
/// all commands.
class PaletteModel : public RowListModel<PaletteRow> {
  Q_OBJECT

 public:
  static constexpr std::size_t kMostThings = 50;

  PaletteModel(QList<QAction*> actions, const CatalogueModel& catalogue, QObject* parent = nullptr);

  /// Ignores case. Searches the present objects.
  void find(const QString& words);

  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

 private:
  QList<QAction*> actions_;
  const CatalogueModel& catalogue_;
};

}  // namespace tendon::gui
