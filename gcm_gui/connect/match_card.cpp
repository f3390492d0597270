#include <gcm_gui/connect/match_card.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/header_row.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/state_mark.h>
#include <gcm_gui/theme/theme.h>
#include <tendon/gcm/interface_matching.h>

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace tendon::gui {
namespace {

QString PathText(const InterfaceName& name) { return ToQString(ToString(name)); }

QLabel* MakeCell(const QString& text, const QString& role) {
  auto* label = new QLabel(text);
  label->setTextFormat(Qt::PlainText);
  SetRole(*label, role);
  return label;
}

QStringList PathsOf(const std::vector<InterfaceName>& names) {
  QStringList paths;
  for (const auto& name : names) paths.append(PathText(name));
  return paths;
}

}  // namespace

MatchCard::MatchCard(QWidget& place, const CatalogueStore& store, SystemActions& actions)
    : OverlayCard(place, new QWidget),
      store_(store),
      actions_(actions),
      about_(MakeCell({}, QStringLiteral("dim"))),
      connect_(new QPushButton) {
  setObjectName(QStringLiteral("matchCard"));
  setAccessibleName(Words::tr("Match by name and type"));
  head().setTitle(Words::tr("Match by name and type"));
  connect_->setObjectName(QStringLiteral("match.connect"));
  connect_->setProperty("changesSystem", true);
  SetRole(*connect_, QStringLiteral("primary"));
  connect(connect_, &QPushButton::clicked, this, &MatchCard::connectChecked);
  addToHead(connect_);
  about_->setObjectName(QStringLiteral("match.about"));
  about_->setWordWrap(true);
  auto* lines = new QVBoxLayout(&body());
  lines->setContentsMargins(kInset, 2 * kGrid, kInset, 2 * kGrid);
  lines->setSpacing(2 * kGrid);
  lines->addWidget(about_);
}

void MatchCard::open(const std::vector<InterfaceName>& required) {
  delete std::exchange(table_, new QWidget);
  rows_.clear();
  grid_ = new QGridLayout(table_);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(kInset);
  grid_->setVerticalSpacing(kGrid);
  grid_->setColumnStretch(2, 1);
  for (const auto& name : required) addRow(name);
  body().layout()->addWidget(table_);
  table_->show();
  QWidget* before = &leave();
  for (const Row& row : rows_) {
    setTabOrder(before, row.box);
    before = row.box;
  }
  about_->setText(Words::tr("%1 of %2 required interfaces have a candidate. Space checks a row, "
                            "Enter connects all checked rows.")
                      .arg(rows_.size())
                      .arg(required.size()));
  count();
  OverlayCard::open();
  if (!rows_.empty()) rows_.front().box->setFocus(Qt::ShortcutFocusReason);
}

void MatchCard::addRow(const InterfaceName& required) {
  const int line = grid_->rowCount();
  auto* box = new QCheckBox(PathText(required));
  box->setObjectName(QStringLiteral("match.") + PathText(required));
  grid_->addWidget(box, line, 0);
  const auto say = [&](const QString& provided, const QString& remark) {
    grid_->addWidget(MakeCell(provided, QStringLiteral("mono")), line, 1);
    grid_->addWidget(MakeCell(remark, QStringLiteral("dim")), line, 2);
    box->setAccessibleName(
        QStringList{PathText(required), provided, remark}.join(' ').simplified());
  };
  if (const auto* connection = store_.catalogue().FindConnection(required)) {
    box->setEnabled(false);
    return say(QStringLiteral("→ ") + PathText(connection->provided),
               WordOf(StateMark::kConnected));
  }
  const auto matches = MatchInterfaces(store_.catalogue(), {ToString(required), "**"});
  if (!matches || matches->empty() || matches->front().provided.empty()) {
    box->setEnabled(false);
    return say({}, Words::tr("no available interface fits"));
  }
  const std::vector<InterfaceName>& found = matches->front().provided;
  box->setChecked(found.size() == 1);
  connect(box, &QCheckBox::toggled, this, &MatchCard::count);
  say(QStringLiteral("→ ") + PathText(found.front()),
      found.size() == 1 ? QString() : Words::tr("one of %1").arg(found.size()));
  box->setToolTip(PathsOf(found).join('\n'));
  rows_.push_back({required, found.front(), box});
}

void MatchCard::count() {
  const auto checked =
      std::ranges::count_if(rows_, [](const Row& row) { return row.box->isChecked(); });
  connect_->setText(Words::tr("Connect %1").arg(checked));
  connect_->setAccessibleName(connect_->text() + Words::tr(" interfaces"));
  connect_->setEnabled(checked > 0);
}

void MatchCard::enter() {
  if (connect_->isEnabled()) connectChecked();
}

void MatchCard::connectChecked() {
  for (const Row& row : rows_) {
    if (row.box->isChecked()) actions_.connectInterfaces(row.required, row.provided);
  }
  close();
}

}  // namespace tendon::gui
