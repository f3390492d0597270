#include <gcm_gui/console/console_page.h>

#include <gcm_console/completion/completer.h>
#include <gcm_console/shell/command_parser.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTextCursor>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace tendon::gui {
namespace {

constexpr int kFewestColumns = 40;

/// Completes the last word of the line as far as all suggestions agree. Returns no value if nothing
/// can be added.
std::optional<QString> Completed(const QString& line, const console::WordCompletion& completion) {
  const auto unfinished = console::ParsePartialCommand(line.toStdString());
  const std::string& word = unfinished.words.back();
  std::string common = console::CommonBegin(completion.suggestions);
  if (common.size() <= word.size()) return std::nullopt;
  const bool is_whole = completion.suggestions.size() == 1 && common.ends_with(' ');
  if (is_whole) common.pop_back();
  const QString begin = line.left(line.size() - ToQString(unfinished.typed).size());
  return begin + ToQString(console::QuoteWord(common)) +
         (is_whole ? QStringLiteral(" ") : QString());
}

QString ListOf(const std::vector<console::WordCompletion::Suggestion>& suggestions) {
  qsizetype widest = 0;
  for (const auto& one : suggestions) widest = std::max(widest, ToQString(one.text).size());
  QString list;
  for (const auto& [text, help] : suggestions) {
    list += ToQString(text).leftJustified(widest) + QStringLiteral("  ") + ToQString(help) + '\n';
  }
  return list;
}

}  // namespace

ConsolePage::ConsolePage(console::Settings settings, const QString& history, QWidget* parent)
    : QWidget(parent), runner_(std::move(settings)), history_(history) {
  setObjectName(QStringLiteral("consolePage"));
  build();
  connect(&runner_, &ConsoleRunner::output, this, &ConsolePage::write);
  connect(&runner_, &ConsoleRunner::finished, this, &ConsolePage::showPrompt);
  connect(&runner_, &ConsoleRunner::promptChanged, this, [this](const QString& prompt) {
    prompt_ = prompt;
    showPrompt();
  });
  connect(&history_, &ConsoleHistory::notice, this, &ConsolePage::notice);
  connect(&runner_, &ConsoleRunner::completed, this, &ConsolePage::showCompletion);
  connect(&Theme::instance(), &Theme::changed, this, &ConsolePage::applyFont);
  applyFont();
  showPrompt();
}

void ConsolePage::build() {
  output_ = new QPlainTextEdit;
  output_->setObjectName(QStringLiteral("console.output"));
  output_->setAccessibleName(Words::tr("Console output"));
  output_->setReadOnly(true);
  output_->setAcceptDrops(false);  // by default, it would keep drops from the window
  output_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  output_->setMaximumBlockCount(kKeptLines);
  output_->setUndoRedoEnabled(false);
  output_->setTabChangesFocus(true);
  output_->setWordWrapMode(QTextOption::WrapAnywhere);
  output_->document()->setDocumentMargin(2 * kGrid);
  output_->setPlaceholderText(
      Words::tr("Accepts the commands of gcm shell: try ls, watch, call … or help. Tab completes, "
                "Ctrl+C interrupts, Ctrl+R searches the history."));
  output_->installEventFilter(this);
  prompt_label_ = new QLabel;
  prompt_label_->setObjectName(QStringLiteral("console.prompt"));
  prompt_label_->setTextFormat(Qt::PlainText);
  line_ = new QLineEdit;
  line_->setObjectName(QStringLiteral("console.line"));
  line_->setAccessibleName(Words::tr("Console line"));
  line_->setFrame(false);
  line_->installEventFilter(this);
  SetRole(*line_, QStringLiteral("mono"));
  prompt_label_->setBuddy(line_);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(kInset, kGrid, kInset - 2, kGrid + 2);
  row->setSpacing(2 * kGrid);
  row->addWidget(prompt_label_);
  row->addWidget(line_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(output_, 1);
  column->addLayout(row);
}

void ConsolePage::applyFont() {
  const QFont& mono = Theme::instance().mono();
  output_->setFont(mono);
  prompt_label_->setFont(mono);
  output_->setTabStopDistance(8 * QFontMetricsF(mono).horizontalAdvance('0'));
}

int ConsolePage::columns() const {
  const QFontMetricsF metrics(output_->font());
  const double width = output_->viewport()->width() - 2 * output_->document()->documentMargin();
  return std::max(static_cast<int>(width / metrics.horizontalAdvance('0')) - 1, kFewestColumns);
}

void ConsolePage::focusLine() { line_->setFocus(); }

QString ConsolePage::text() const { return output_->toPlainText(); }

void ConsolePage::write(const QString& text, bool is_message) {
  QTextCursor selected = output_->textCursor();
  QScrollBar* bar = output_->verticalScrollBar();
  const bool was_at_end = bar->value() >= bar->maximum();
  const int place = bar->value();
  QTextCursor end(output_->document());
  end.movePosition(QTextCursor::End);
  QTextCharFormat format;
  if (is_message) format.setForeground(Theme::instance().color(Token::kWarning));
  end.insertText(text, format);
  // Keeps the selection when output is added.
  if (selected.hasSelection()) output_->setTextCursor(selected);
  bar->setValue(was_at_end ? bar->maximum() : place);
}

void ConsolePage::showPrompt() {
  QString text = prompt_.trimmed();
  QString role = QStringLiteral("accent mono");
  if (search_) {
    const bool is_found = search_->part.isEmpty() || search_->place >= 0;
    text =
        (is_found ? Words::tr("search '%1':") : Words::tr("nothing with '%1':")).arg(search_->part);
  } else if (runner_.isRunning()) {
    text = Words::tr("… Ctrl+C");
    role = QStringLiteral("dim mono");
  }
  SetRole(*prompt_label_, role);
  prompt_label_->setText(text);
}

bool ConsolePage::isTyping(const QKeyEvent& key) {
  return !key.text().isEmpty() && key.text()[0].isPrint() &&
         (key.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) == 0;
}

bool ConsolePage::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    // If the console uses a key, the shortcut of the window with the same key is not called.
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const bool is_control = key.modifiers() == Qt::ControlModifier;
    const bool is_ours = (is_control && (key.key() == Qt::Key_C || key.key() == Qt::Key_R ||
                                         key.key() == Qt::Key_L)) ||
                         (search_ && key.key() == Qt::Key_Escape) || isTyping(key);
    if (is_ours) event->accept();
    return is_ours;
  }
  if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const auto& key = static_cast<const QKeyEvent&>(*event);
  if (watched == line_) return search_ ? pressInSearch(key) : pressKey(key);
  if (key.modifiers() == Qt::ControlModifier && key.key() == Qt::Key_C) {
    copyOrInterrupt();
    return true;
  }
  if (!isTyping(key)) return false;
  line_->setFocus();
  line_->insert(key.text());
  return true;
}

bool ConsolePage::pressKey(const QKeyEvent& event) {
  if (event.modifiers() == Qt::ControlModifier) return pressControl(event.key());
  switch (event.key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      submit();
      return true;
    case Qt::Key_Up:
      line_->setText(history_.older(line_->text()));
      return true;
    case Qt::Key_Down:
      line_->setText(history_.newer());
      return true;
    case Qt::Key_Tab:
      if (line_->text().isEmpty()) return false;  // Tab then moves the focus
      complete();
      return true;
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
      output_->verticalScrollBar()->triggerAction(event.key() == Qt::Key_PageUp
                                                      ? QAbstractSlider::SliderPageStepSub
                                                      : QAbstractSlider::SliderPageStepAdd);
      return true;
    default:
      return false;
  }
}

bool ConsolePage::pressControl(int key) {
  if (key == Qt::Key_C) {
    copyOrInterrupt();
  } else if (key == Qt::Key_R) {
    search_ = Search{{}, line_->text(), -1};
    showPrompt();
  } else if (key == Qt::Key_L) {
    output_->clear();
  } else {
    return false;
  }
  return true;
}

bool ConsolePage::pressInSearch(const QKeyEvent& event) {
  const bool is_control = event.modifiers() == Qt::ControlModifier;
  if (is_control && event.key() == Qt::Key_R) {
    searchFrom((search_->place < 0 ? history_.lines().size() : search_->place) - 1);
    return true;
  }
  if (event.key() == Qt::Key_Escape || (is_control && event.key() == Qt::Key_C)) {
    line_->setText(search_->typed);
    leaveSearch();
    return true;
  }
  if (event.key() == Qt::Key_Backspace) {
    search_->part.chop(1);
    searchFrom(history_.lines().size() - 1);
    return true;
  }
  const QString typed = event.text();
  if (!is_control && !typed.isEmpty() && typed[0].isPrint()) {
    search_->part += typed;
    searchFrom(search_->place < 0 ? history_.lines().size() - 1 : search_->place);
    return true;
  }
  const bool is_modifier = event.key() == Qt::Key_Shift || event.key() == Qt::Key_Control ||
                           event.key() == Qt::Key_Alt || event.key() == Qt::Key_Meta;
  if (is_modifier) return false;
  leaveSearch();  // keeps the line that was found; the key then edits it
  return pressKey(event);
}

void ConsolePage::searchFrom(qsizetype before) {
  const qsizetype found = search_->part.isEmpty() ? -1 : history_.find(search_->part, before);
  if (found >= 0) {
    search_->place = found;
    line_->setText(history_.lines()[found]);
  } else if (search_->place < 0 || !line_->text().contains(search_->part, Qt::CaseInsensitive)) {
    search_->place = -1;
    line_->setText(search_->typed);
  }
  showPrompt();
}

void ConsolePage::leaveSearch() {
  search_.reset();
  showPrompt();
}

void ConsolePage::submit() {
  if (runner_.isRunning()) return;
  const QString line = line_->text();
  history_.add(line);
  line_->clear();
  output_->moveCursor(QTextCursor::End);
  if (!text().isEmpty() && !text().endsWith('\n')) write(QStringLiteral("\n"), false);
  QTextCursor end(output_->document());
  end.movePosition(QTextCursor::End);
  QTextCharFormat format;
  format.setForeground(Theme::instance().color(Token::kAccent));
  end.insertText(prompt_, format);
  write(line + '\n', false);
  output_->verticalScrollBar()->setValue(output_->verticalScrollBar()->maximum());
  if (line.trimmed().isEmpty()) return;
  runner_.run(line, columns());
  showPrompt();
}

void ConsolePage::copyOrInterrupt() {
  if (line_->hasFocus() && line_->hasSelectedText()) return line_->copy();
  if (output_->textCursor().hasSelection()) return output_->copy();
  if (runner_.isRunning()) {
    write(QStringLiteral("^C\n"), false);
    return runner_.interrupt();
  }
  line_->clear();
}

void ConsolePage::complete() {
  if (line_->cursorPosition() == line_->text().size()) runner_.complete(line_->text());
}

void ConsolePage::showCompletion(const QString& line, const console::WordCompletion& completion) {
  if (line != line_->text()) return;  // the user has changed the line since the request
  if (completion.suggestions.empty()) return QApplication::beep();
  if (const auto completed = Completed(line, completion)) return line_->setText(*completed);
  if (!text().isEmpty() && !text().endsWith('\n')) write(QStringLiteral("\n"), false);
  write(ListOf(completion.suggestions), false);
}

}  // namespace tendon::gui
