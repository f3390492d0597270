#include <gcm_gui/connect/candidate_list.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/row_delegate.h>

#include <QFontMetrics>
#include <QHeaderView>
#include <QPainter>

namespace tendon::gui {
namespace {

constexpr int kReasonInset = 34;  // indents the reasons below the names
constexpr int kWrapped = static_cast<int>(Qt::AlignLeft | Qt::AlignTop) | Qt::TextWordWrap;

class CandidateDelegate final : public RowDelegate {
 public:
  using RowDelegate::RowDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    if (!index.parent().isValid()) return RowDelegate::paint(painter, option, index);
    painter->save();
    painter->setFont(Theme::instance().text());
    painter->setPen(Theme::instance().color(Token::kDim));
    painter->drawText(option.rect.adjusted(kReasonInset, 0, -kInset, 0), kWrapped,
                      index.data().toString());
    painter->restore();
  }

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                               const QModelIndex& index) const override {
    if (!index.parent().isValid()) return RowDelegate::sizeHint(option, index);
    const auto* view = static_cast<const QAbstractItemView*>(option.widget);
    const QRect room(0, 0, view->viewport()->width() - kReasonInset - kInset, 1000);
    const QFontMetrics metrics(Theme::instance().text());
    const QRect needed = metrics.boundingRect(room, kWrapped, index.data().toString());
    return {room.width(), needed.height() + kGrid};
  }
};

}  // namespace

CandidateList::CandidateList(CandidatesModel& model, QWidget* parent) : RowView(parent) {
  setObjectName(QStringLiteral("candidates"));
  setAccessibleName(Words::tr("Candidates"));
  setItemDelegate(new CandidateDelegate(this));
  setUniformRowHeights(false);
  setRootIsDecorated(false);
  setIndentation(0);
  setWordWrap(true);
  setModel(&model);
  header()->setSectionResizeMode(0, QHeaderView::Stretch);
  setEmptyText(Words::tr("No candidate matches the filter."));
  connect(&model, &QAbstractItemModel::modelReset, this, [this] {
    expandAll();
    setCurrentIndex(this->model()->index(0, 0));
  });
  expandAll();
}

void CandidateList::resizeEvent(QResizeEvent* event) {
  RowView::resizeEvent(event);
  scheduleDelayedItemsLayout();  // because the reasons are wrapped differently now
}

}  // namespace tendon::gui
