#include <gcm_gui/replay/recorded_signal_dialog.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/row_delegate.h>
#include <gcm_gui/views/row_view.h>
#include <tendon/payload/numeric_field.h>

#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

namespace tendon::gui {
namespace {

constexpr QSize kDialog{560, 420};
constexpr int kUnitWidth = 96;
enum SignalColumn { kSignalPath, kSignalUnit, kSignalColumns };

}  // namespace

RecordedSignalDialog::RecordedSignalDialog(const QString& file, QSet<QString> plotted,
                                           QWidget* parent)
    : QDialog(parent),
      file_(file),
      plotted_(std::move(plotted)),
      rows_(0, kSignalColumns),
      filter_(new QLineEdit),
      status_(new QLabel(Words::tr("The recording is being opened…"))),
      add_(new QPushButton(Words::tr("Add to the plot"))) {
  setObjectName(QStringLiteral("recordedSignalDialog"));
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(Words::tr("Add curves of %1").arg(QFileInfo(file).fileName()));
  shown_.setSourceModel(&rows_);
  list_ = MakeRowList(shown_, QStringLiteral("recordedSignals"), Words::tr("Recorded signals"),
                      Words::tr("There is no such number in this recording."));
  shown_.setFilterCaseSensitivity(Qt::CaseInsensitive);
  build();
  connect(filter_, &QLineEdit::textChanged, &shown_, &QSortFilterProxyModel::setFilterFixedString);
  connect(list_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &RecordedSignalDialog::showState);
  connect(list_, &QTreeView::doubleClicked, this, &RecordedSignalDialog::choose);
  connect(add_, &QPushButton::clicked, this, &RecordedSignalDialog::choose);
  connect(&reader_, &ReplayReader::opened, this, &RecordedSignalDialog::fill);
  connect(&reader_, &ReplayReader::refused, this, [this](const QString& sentence) {
    SetRole(*status_, QStringLiteral("bad"));
    status_->setText(sentence);
  });
  reader_.open(file);
}

void RecordedSignalDialog::build() {
  filter_->setObjectName(QStringLiteral("recordedSignals.filter"));
  filter_->setPlaceholderText(Words::tr("Filter"));
  filter_->setAccessibleName(Words::tr("Filter of the recorded signals"));
  filter_->setClearButtonEnabled(true);
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->rows().setLeftInset(2 * kGrid);
  status_->setObjectName(QStringLiteral("recordedSignals.status"));
  status_->setTextFormat(Qt::PlainText);
  status_->setWordWrap(true);
  SetRole(*status_, QStringLiteral("dim"));
  SetRole(*add_, QStringLiteral("primary"));
  add_->setObjectName(QStringLiteral("recordedSignals.add"));
  add_->setDefault(true);
  add_->setEnabled(false);
  auto* cancel = new QPushButton(Words::tr("Cancel"));
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(status_, 1);
  buttons->addWidget(cancel);
  buttons->addWidget(add_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kInset, kInset, kInset, kInset);
  column->setSpacing(2 * kGrid);
  column->addWidget(filter_);
  column->addWidget(list_, 1);
  column->addLayout(buttons);
  resize(kDialog);
}

void RecordedSignalDialog::fill(const RecordingFacts& facts) {
  facts_ = facts;
  int first_other = 0;
  for (const auto& [path, schema] : facts.columns) {
    for (const NumericField& field : NumericFields(schema)) {
      const QString signal = ToQString(path + field.path);
      const bool is_plotted = plotted_.contains(signal);
      auto* name = new QStandardItem(signal);
      auto* unit = new QStandardItem(ToQString(field.unit));
      for (QStandardItem* item : {name, unit}) item->setEditable(false);
      rows_.insertRow(is_plotted ? first_other : rows_.rowCount(), {name, unit});
      if (!is_plotted) continue;
      const QModelIndex index = shown_.index(first_other++, kSignalPath);
      list_->selectionModel()->select(index,
                                      QItemSelectionModel::Select | QItemSelectionModel::Rows);
    }
  }
  list_->header()->resizeSection(kSignalUnit, kUnitWidth);
  filter_->setFocus();
  showState();
}

QList<CurveKey> RecordedSignalDialog::selected() const {
  QList<CurveKey> keys;
  for (const QModelIndex& index : list_->selectionModel()->selectedRows(kSignalPath)) {
    keys << CurveKey{.path = RecordedPath(file_, index.data().toString()),
                     .unit = index.siblingAtColumn(kSignalUnit).data().toString()};
  }
  return keys;
}

void RecordedSignalDialog::showState() {
  const int selected = static_cast<int>(list_->selectionModel()->selectedRows(kSignalPath).size());
  add_->setEnabled(selected > 0);
  status_->setText(selected == 0 ? Words::tr("Select one or more of %1 signals").arg(count())
                                 : Words::tr("%1 of %2 selected").arg(selected).arg(count()));
}

void RecordedSignalDialog::choose() {
  const QList<CurveKey> keys = selected();
  if (keys.isEmpty()) return;
  Q_EMIT chosen(keys, facts_.first);
  close();
}

}  // namespace tendon::gui
