#include <gcm_gui/views/catalogue_columns.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/catalogue_model.h>
#include <gcm_gui/views/row_delegate.h>
#include <gcm_gui/views/row_view.h>

#include <QAction>
#include <QDataStream>
#include <QEvent>
#include <QHeaderView>
#include <QIODevice>
#include <QMenu>
#include <QScopedValueRollback>
#include <algorithm>
#include <array>
#include <iterator>

namespace tendon::gui {
namespace {

using Model = CatalogueModel;

constexpr int kMinName = 176;  // pixels; if there is less room, the columns scroll horizontally
constexpr int kNarrowestColumn = 24;  // minimum of saved widths
constexpr int kWidestColumn = 2000;   // maximum of saved widths
constexpr quint32 kStateVersion = 1;

struct ColumnDefaults {
  const char* title;
  int width;
  bool is_shown;
};
// The array has no entry for the first column.
constexpr std::array<ColumnDefaults, Model::kColumnCount - 1> kColumnDefaults{
    {{QT_TRANSLATE_NOOP("Words", "Column: state and value"), 156, true},
     {QT_TRANSLATE_NOOP("Words", "Column: rate"), 76, false},
     {QT_TRANSLATE_NOOP("Words", "Column: age"), 64, false},
     {QT_TRANSLATE_NOOP("Words", "Column: connected to"), 128, false}}};

}  // namespace

CatalogueColumns::CatalogueColumns(RowView& tree) : QObject(&tree), tree_(tree) {
  QHeaderView& header = *tree.header();
  header.setObjectName(QStringLiteral("catalogue.columns"));
  header.setAccessibleName(Words::tr("Columns of the catalogue"));
  header.setSectionsMovable(false);
  header.setContextMenuPolicy(Qt::CustomContextMenu);
  auto* menu = new QMenu(&tree);
  menu->setObjectName(QStringLiteral("catalogue.columnsMenu"));
  for (const ColumnDefaults& usual : kColumnDefaults) {
    QAction* action = menu->addAction(Words::tr(usual.title));
    action->setObjectName(action->text());
    action->setCheckable(true);
    connect(action, &QAction::toggled, this, &CatalogueColumns::arrange);
    actions_.append(action);
    widths_.append(usual.width);
  }
  connect(&header, &QWidget::customContextMenuRequested, menu,
          [&header, menu](const QPoint& place) { menu->popup(header.mapToGlobal(place)); });
  connect(&header, &QHeaderView::sectionResized, this,
          [this](int column, int, int width) { noteWidth(column, width); });
  tree.viewport()->installEventFilter(this);
  reset();
}

void CatalogueColumns::setShown(int column, bool shown) { actions_[column - 1]->setChecked(shown); }

bool CatalogueColumns::isShown(int column) const { return actions_[column - 1]->isChecked(); }

bool CatalogueColumns::isTable() const {
  return std::any_of(std::next(actions_.begin()), actions_.end(),
                     [](const QAction* action) { return action->isChecked(); });
}

void CatalogueColumns::arrange() {
  const bool is_table = isTable();
  const bool has_value = isShown(Model::kValue);
  tree_.setHeaderHidden(!is_table);
  tree_.setHorizontalScrollBarPolicy(is_table ? Qt::ScrollBarAsNeeded : Qt::ScrollBarAlwaysOff);
  tree_.rows().setValueColumn(has_value && !is_table ? Model::kValue : -1);
  for (int column = Model::kValue; column < Model::kColumnCount; ++column) {
    tree_.setColumnHidden(column, !is_table || !isShown(column));
  }
  fitName();
  tree_.viewport()->update();
}

/// Sets the width of the name to the width that the other columns leave.
void CatalogueColumns::fitName() {
  if (fitting_) return;
  const QScopedValueRollback guard(fitting_, true);
  QHeaderView& header = *tree_.header();
  const int others = header.length() - header.sectionSize(Model::kName);
  header.setSectionResizeMode(Model::kName, QHeaderView::Fixed);
  header.resizeSection(Model::kName, std::max(kMinName, tree_.viewport()->width() - others));
}

bool CatalogueColumns::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) fitName();
  return QObject::eventFilter(watched, event);
}

void CatalogueColumns::noteWidth(int column, int width) {
  if (column != Model::kName && width > 0) widths_[column - 1] = width;
  fitName();
}

void CatalogueColumns::setLook(int column, const Look& look) {
  widths_[column - 1] = look.width;
  tree_.header()->resizeSection(column, look.width);
  setShown(column, look.is_shown);
}

QByteArray CatalogueColumns::state() const {
  QByteArray state;
  QDataStream stream(&state, QIODevice::WriteOnly);
  stream << kStateVersion << static_cast<quint32>(kColumnDefaults.size());
  for (int column = Model::kValue; column < Model::kColumnCount; ++column) {
    stream << isShown(column) << static_cast<qint32>(widths_[column - 1]);
  }
  return state;
}

void CatalogueColumns::restore(const QByteArray& state) {
  QDataStream stream(state);
  quint32 version = 0;
  quint32 count = 0;
  stream >> version >> count;
  if (version != kStateVersion || count != kColumnDefaults.size()) return;
  std::array<Look, kColumnDefaults.size()> looks;
  for (Look& look : looks) {
    qint32 width = 0;
    stream >> look.is_shown >> width;
    look.width = std::clamp(width, kNarrowestColumn, kWidestColumn);
  }
  if (stream.status() != QDataStream::Ok) return;
  for (std::size_t i = 0; i < looks.size(); ++i) setLook(static_cast<int>(i) + 1, looks[i]);
  arrange();
}

void CatalogueColumns::reset() {
  for (std::size_t i = 0; i < kColumnDefaults.size(); ++i) {
    setLook(static_cast<int>(i) + 1,
            {.width = kColumnDefaults[i].width, .is_shown = kColumnDefaults[i].is_shown});
  }
  arrange();
}

}  // namespace tendon::gui
