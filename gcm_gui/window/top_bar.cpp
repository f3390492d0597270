#include <gcm_gui/window/top_bar.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/recording/record_button.h>
#include <gcm_gui/theme/icon.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/window/pill.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace tendon::gui {
namespace {

constexpr int kLogo = 20;
// Below these widths of the window, the switches and the search show only their icons, so that the
// state of the GCM has room.
constexpr int kRoomForSwitches = 1440;
constexpr int kRoomForSearch = 1200;

/// Counts only objects that exist now, because the catalogue also contains objects that are gone.
QString Counts(const Catalogue& catalogue) {
  std::int64_t processes = 0;
  std::int64_t components = 0;
  std::int64_t connections = 0;
  for (const auto& [name, entry] : catalogue.processes()) {
    if (IsGone(entry.process.state)) continue;
    ++processes;
    components += static_cast<std::int64_t>(entry.components.size());
    connections += static_cast<std::int64_t>(entry.connections.size());
  }
  const auto count = [](std::int64_t number, const QString& one, const QString& many) {
    return (number == 1 ? one : many).arg(number);
  };
  return QStringList{count(processes, Words::tr("%1 process"), Words::tr("%1 processes")),
                     count(components, Words::tr("%1 component"), Words::tr("%1 components")),
                     count(connections, Words::tr("%1 connection"), Words::tr("%1 connections"))}
      .join(QStringLiteral(" · "));
}

int TextWidth(const QPushButton& button) {
  return button.text().isEmpty() ? 0 : button.fontMetrics().horizontalAdvance(button.text());
}

}  // namespace

TopBar::TopBar(const CatalogueStore& store, const LinkState& link, QWidget* parent)
    : QFrame(parent),
      store_(store),
      link_(link),
      link_pill_(new Pill),
      problem_pill_(new Pill),
      search_(new QPushButton),
      pause_(new QPushButton),
      theme_(new QPushButton) {
  setObjectName(QStringLiteral("topBar"));
  setAutoFillBackground(true);
  setFixedHeight(kTopBarHeight);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(kInset, 0, kInset, 0);
  row->setSpacing(kInset);
  auto* logo = new QLabel;
  const auto draw_logo = [logo] {
    logo->setPixmap(ThemeIcon(QStringLiteral("logo"), Token::kAccent).pixmap(kLogo, kLogo));
  };
  draw_logo();
  connect(&Theme::instance(), &Theme::changed, logo, draw_logo);
  link_pill_->setObjectName(QStringLiteral("gcmState"));
  link_pill_->setFocusPolicy(Qt::NoFocus);
  problem_pill_->setObjectName(QStringLiteral("problemCount"));
  row->addWidget(logo);
  row->addWidget(link_pill_);
  row->addWidget(problem_pill_);
  row->addStretch();
  addButtons();

  connect(problem_pill_, &QAbstractButton::clicked, this, &TopBar::problemsRequested);
  connect(&store, &CatalogueStore::changed, this, Guarded(this, &TopBar::showLink));
  connect(&link, &LinkState::changed, this, Guarded(this, &TopBar::showLink));
  setNow(WallClock());
  showProblemCount(0);
}

void TopBar::addButtons() {
  auto* row = static_cast<QHBoxLayout*>(layout());
  search_->setObjectName(QStringLiteral("searchOrRun"));
  search_->setIcon(ThemeIcon(QStringLiteral("search")));
  search_->setAccessibleName(Words::tr("Search or run   Ctrl+K"));
  search_->setToolTip(Words::tr("Finds all commands and all objects  (Ctrl+K)"));
  search_->setFocusPolicy(Qt::TabFocus);
  SetRole(*search_, QStringLiteral("field"));
  connect(search_, &QPushButton::clicked, this, &TopBar::paletteRequested);
  pause_->setObjectName(QStringLiteral("pause"));
  pause_->setCheckable(true);
  pause_->setToolTip(Words::tr("Pauses the display; new data is still received  (Space)"));
  pause_->setFocusPolicy(Qt::TabFocus);
  connect(pause_, &QPushButton::clicked, this, &TopBar::pauseRequested);
  theme_->setObjectName(QStringLiteral("theme"));
  theme_->setAccessibleName(Words::tr("Dark or light"));
  theme_->setToolTip(Words::tr("Dark or light"));
  theme_->setIcon(ThemeIcon(QStringLiteral("theme"), Token::kText));
  theme_->setFocusPolicy(Qt::TabFocus);
  connect(theme_, &QPushButton::clicked, &Theme::instance(), &Theme::toggle);
  row->addWidget(search_);
  row->addWidget(pause_);
  row->addWidget(theme_);
  showPaused(false);
}

void TopBar::addMenus(QWidget* menus) {
  static_cast<QHBoxLayout*>(layout())->insertWidget(1, menus);
}

void TopBar::addRecordButton(RecordButton* button) {
  auto* row = static_cast<QHBoxLayout*>(layout());
  row->insertWidget(row->indexOf(pause_), button);
  record_ = button;
  record_->setTabPlace(search_, pause_);
  showTexts();
}

void TopBar::showTexts() {
  const bool has_room = width() >= kRoomForSwitches;
  pause_->setText(has_room ? pause_->accessibleName() : QString());
  if (record_ != nullptr) record_->setTextShown(has_room);
  search_->setText(width() >= kRoomForSearch ? search_->accessibleName() : QString());
}

QSize TopBar::minimumSizeHint() const {
  QSize size = QFrame::minimumSizeHint();
  size.rwidth() -= TextWidth(*search_) + TextWidth(*pause_);
  if (record_ != nullptr) size.rwidth() -= record_->textWidth();
  return size;
}

void TopBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  showTexts();
}

QString TopBar::linkText() const { return link_pill_->spoken(); }

void TopBar::showLink() {
  if (link_.isFile()) return showFile();
  const QString age = AgeText(now_ - link_.since());
  switch (link_.state()) {
    case LinkState::State::kSearching:
      link_pill_->show(StateMark::kPending, Words::tr("No GCM found at ") + link_.address(),
                       Words::tr("searching every second"));
      break;
    case LinkState::State::kLost:
      link_pill_->show(StateMark::kLost, Words::tr("GCM lost %1 ago").arg(age),
                       Words::tr("retrying ") + link_.address());
      break;
    case LinkState::State::kConnected:
      link_pill_->show(StateMark::kActive,
                       link_.isHosted() ? Words::tr("Hosting the GCM on this machine")
                                        : Words::tr("GCM at ") + link_.address(),
                       Counts(store_.catalogue()));
      break;
  }
  link_pill_->setToolTip(Words::tr("The global component manager (GCM) at %1 knows every process "
                                   "and makes the connections between the processes.")
                             .arg(link_.address()) +
                         (link_.reason().isEmpty() ? QString() : '\n' + link_.reason()));
}

void TopBar::showFile() {
  const bool is_open = link_.state() == LinkState::State::kConnected;
  const bool is_refused = !is_open && !link_.reason().isEmpty();
  link_pill_->show(is_open      ? StateMark::kReady
                   : is_refused ? StateMark::kRefused
                                : StateMark::kPending,
                   Words::tr("Recorded system"),
                   is_open      ? Counts(store_.catalogue())
                   : is_refused ? Words::tr("cannot be shown")
                                : QString());
  link_pill_->setToolTip(
      Words::tr("This window shows the recording %1. It is connected to no running system.")
          .arg(link_.address()));
  pause_->hide();
}

void TopBar::showProblemCount(int count) {
  problem_pill_->show(StateMark::kWarning, QString::number(count));
  problem_pill_->setAccessibleName(count == 1 ? Words::tr("1 problem")
                                              : Words::tr("%1 problems").arg(count));
  problem_pill_->setVisible(count > 0);
}

void TopBar::showPaused(bool paused) {
  pause_->setChecked(paused);
  pause_->setAccessibleName(paused ? Words::tr("Resume view") : Words::tr("Pause view"));
  pause_->setIcon(
      ThemeIcon(paused ? QStringLiteral("play") : QStringLiteral("pause"), Token::kText));
  showTexts();
}

void TopBar::setNow(qint64 now) {
  now_ = now;
  showLink();
}

}  // namespace tendon::gui
