#pragma once

#include <gcm_gui/models/catalogue_model.h>
#include <gcm_gui/models/row_list_model.h>

#include <QList>
#include <QString>
#include <cstddef>

class QAction;

namespace tendon::gui {

/// A command, or an object of the catalogue to go to.
struct PaletteRow {
  QAction* action = nullptr;
  QString text;   ///< the path, if the row is an object
  QString trail;  ///< the key of a command, or the kind of an object

  bool operator==(const PaletteRow&) const = default;
};

/// The rows that match some typed words: commands first, then objects, each with the best match
/// first. If no text contains the words, the model shows texts that contain their letters in the
/// same order, with only a few letters in between. Without words it shows all commands.
class PaletteModel : public RowListModel<PaletteRow> {
  Q_OBJECT

 public:
  static constexpr std::size_t kMaxThings = 50;

  PaletteModel(QList<QAction*> actions, const CatalogueModel& catalogue, QObject* parent = nullptr);

  /// Finds the matches among the commands and the present objects, ignoring case.
  void find(const QString& words);

  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

 private:
  QList<QAction*> actions_;
  const CatalogueModel& catalogue_;
};

}  // namespace tendon::gui
