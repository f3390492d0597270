#pragma once

#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/system_requests.h>
#include <gcm_gui/views/overlay_card.h>

#include <QCheckBox>
#include <vector>

class QGridLayout;
class QLabel;
class QPushButton;

namespace tendon::gui {

/// A card that lists several required interfaces, each with the provided interface that matches by
/// name and type. Connects all checked rows at once. If several provided interfaces match equally
/// well, the row shows the first of them and is not checked.
class MatchCard : public OverlayCard {
  Q_OBJECT

 public:
  MatchCard(QWidget& place, const CatalogueStore& store, SystemActions& actions);

  /// Opens the card for the unconnected interfaces among `required`, and finds their matches among
  /// all provided interfaces.
  void open(const std::vector<InterfaceName>& required);

 protected:
  void enter() override;

 private:
  struct Row {
    InterfaceName required;
    InterfaceName provided;
    QCheckBox* box;
  };
  void addRow(const InterfaceName& required);
  void count();
  void connectChecked();

  const CatalogueStore& store_;
  SystemActions& actions_;
  QLabel* about_;
  QWidget* table_ = nullptr;
  QGridLayout* grid_ = nullptr;
  QPushButton* connect_;
  std::vector<Row> rows_;  // interfaces with at least one match
};

}  // namespace tendon::gui
