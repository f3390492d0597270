#include <gcm_gui/call/call_panel.h>

#include <gcm_gui/call/hold_button.h>
#include <gcm_gui/call/repeat_row.h>
#include <gcm_gui/call/value_form.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/header_row.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/image_view.h>
#include <gcm_gui/views/link_button.h>
#include <tendon/gcm/initial_arguments.h>
#include <tendon/gcm/lookup.h>
#include <tendon/payload/json.h>
#include <tendon/payload/json/strict_json.h>
#include <tendon/payload/json/typed_value.h>

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPlainTextEdit>
#include <QPointer>
#include <QScrollArea>
#include <QShortcut>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

namespace tendon::gui {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMaxFormHeight = 232;
constexpr int kJsonHeight = 120;
constexpr qsizetype kLongestResult = 1500;
// The largest result in bytes that is formatted. Formatting a larger one would block the window too
// long.
constexpr std::size_t kMaxRead = 65536;
constexpr std::chrono::seconds kSecondKey{2};
enum ArgumentPage { kFormPage, kJsonPage };

/// Formats a value in one line: numbers with six digits, and lists so that the text can be wrapped.
QString ValueText(const Json& value) {
  if (value.is_number_float()) return QString::number(value.get<double>(), 'g', 6);
  if (!value.is_array()) return ToQString(value.dump());
  QStringList elements;
  for (const Json& element : value) elements << ValueText(element);
  return '[' + elements.join(QStringLiteral(", ")) + ']';
}

QString Rest() { return Words::tr("…\nFor the whole result, use Copy as command"); }

/// Formats a result for people, with one field per line. A very long result is truncated; the same
/// command in a terminal shows all of it.
QString Readable(const std::string& json) {
  if (json.size() > kMaxRead) {
    return ToQString(std::string_view(json).substr(0, kLongestResult)) + Rest();
  }
  const Json value = JsonOrText(json);
  QStringList lines;
  if (value.is_object()) {
    for (const auto& [name, field] : value.items()) {
      lines << ToQString(name) + QStringLiteral(": ") + ValueText(field);
    }
  } else {
    lines << ValueText(value);
  }
  const QString text = lines.join('\n');
  if (text.size() <= kLongestResult) return text;
  return text.left(kLongestResult) + Rest();
}

/// Returns the result without rounding, escaped so that it is never read as markup.
QString WholeResult(const std::string& json) {
  if (json.size() > static_cast<std::size_t>(kLongestResult)) return {};
  return QStringLiteral("<qt>%1</qt>").arg(ToQString(json).toHtmlEscaped());
}

QLabel* MakeWords(const QString& name) {
  auto* words = new QLabel;
  words->setObjectName(name);
  words->setTextFormat(Qt::PlainText);
  words->setWordWrap(true);
  words->setTextInteractionFlags(Qt::TextSelectableByMouse);
  words->setContentsMargins(kInset, 0, kInset, 2 * kGrid);
  return words;
}

}  // namespace

CallPanel::CallPanel(CommandCalls& calls, QWidget* parent) : QWidget(parent), calls_(calls) {
  setObjectName(QStringLiteral("call"));
  setAccessibleName(Words::tr("Call a command"));
  build();
  for (const int key : {Qt::Key_Return, Qt::Key_Enter}) {
    auto* calls_it = new QShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(key)), this, this,
                                   &CallPanel::callByKey, Qt::WidgetWithChildrenShortcut);
    calls_it->setAutoRepeat(false);
  }
  second_key_.setSingleShot(true);
  second_key_.setInterval(kSecondKey);
  setVisible(false);
}

void CallPanel::build() {
  head_ = new HeaderRow(QString());
  kind_ = new QLabel;
  SetRole(*kind_, QStringLiteral("dim mono"));
  head_->addRight(kind_);
  status_ = MakeWords(QStringLiteral("call.status"));
  result_ = MakeWords(QStringLiteral("call.result"));
  result_->setAccessibleName(Words::tr("Result"));
  SetRole(*result_, QStringLiteral("mono"));
  expiry_ = MakeWords(QStringLiteral("call.expiry"));
  SetRole(*expiry_, QStringLiteral("dim"));
  expiry_->setContentsMargins(kInset, 2 * kGrid, kInset, 0);
  picture_ = new ImageView(QString());
  connect(picture_, &ImageView::shown, this,
          [this] { result_->setVisible(picture_->image().isNull()); });
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, kGap, 0, 0);
  column->setSpacing(0);
  column->addWidget(head_);
  column->addWidget(expiry_);
  column->addWidget(buildArgument());
  column->addWidget(buildButtons());
  column->addWidget(repeat_);
  column->addWidget(status_);
  column->addWidget(result_);
  column->addWidget(picture_);
}

QWidget* CallPanel::buildArgument() {
  form_area_ = new QScrollArea;
  form_area_->setFocusPolicy(Qt::NoFocus);  // the widgets inside the area take the focus
  form_area_->setFrameShape(QFrame::NoFrame);
  form_area_->setWidgetResizable(true);
  form_area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  json_ = new QPlainTextEdit;
  json_->setObjectName(QStringLiteral("call.json"));
  json_->setAccessibleName(Words::tr("Argument as JSON"));
  json_->setFont(Theme::instance().mono());
  json_->setTabChangesFocus(true);
  connect(json_, &QPlainTextEdit::textChanged, this, &CallPanel::check);
  argument_ = new QStackedWidget;
  argument_->addWidget(form_area_);
  argument_->addWidget(json_);
  return argument_;
}

QWidget* CallPanel::buildButtons() {
  call_ = new HoldButton(Words::tr("Call"));
  call_->setObjectName(QStringLiteral("call.call"));
  call_->setProperty("changesSystem", true);
  SetRole(*call_, QStringLiteral("primary"));
  connect(call_, &HoldButton::called, this, &CallPanel::call);
  connect(call_, &QAbstractButton::pressed, this, [this] { is_touched_ = true; });
  connect(call_, &HoldButton::releasedEarly, this, [this] {
    showStatus(Words::tr("Not called: this command can move something; hold the button for 0.4 s"),
               QStringLiteral("warning"));
  });
  retry_ = MakeLinkButton(Words::tr("Ask again"), QStringLiteral("call.retry"));
  connect(retry_, &QToolButton::clicked, this, &CallPanel::askForSchema);
  as_json_ = MakeLinkButton(QStringLiteral("JSON"), QStringLiteral("call.asJson"));
  as_json_->setToolTip(Words::tr("Shows the argument as JSON text instead of a form"));
  as_json_->setCheckable(true);
  connect(as_json_, &QToolButton::toggled, this, &CallPanel::showAsJson);
  QToolButton* copy = MakeLinkButton(Words::tr("Copy"), QStringLiteral("call.copy"));
  copy->setAccessibleName(Words::tr("Copy as command"));
  copy->setToolTip(Words::tr("Copies the command line that does the same in a terminal"));
  connect(copy, &QToolButton::clicked, this, &CallPanel::copyCommand);
  QToolButton* favourite = MakeLinkButton(QStringLiteral("★"), QStringLiteral("call.favourite"));
  favourite->setAccessibleName(Words::tr("Add to the favourites"));
  favourite->setToolTip(Words::tr("Adds a button for this command and argument"));
  connect(favourite, &QToolButton::clicked, this,
          [this] { Q_EMIT favouriteRequested(path_, ToQString(argument())); });
  buildRepeat();
  QToolButton* repeat = MakeLinkButton(Words::tr("Repeat"), QStringLiteral("call.showRepeat"));
  repeat->setToolTip(Words::tr("Calls the command repeatedly"));
  repeat->setCheckable(true);
  connect(repeat, &QToolButton::toggled, repeat_, &QWidget::setVisible);
  auto* widget = new QWidget;
  auto* row = new QHBoxLayout(widget);
  row->setContentsMargins(kInset, 2 * kGrid, kInset - 6, 2 * kGrid);
  row->setSpacing(0);
  row->addWidget(call_);
  row->addWidget(retry_);
  row->addStretch();
  row->addWidget(favourite);
  row->addWidget(repeat);
  row->addWidget(as_json_);
  row->addWidget(copy);
  return widget;
}

void CallPanel::buildRepeat() {
  repeat_ = new RepeatRow(calls_, [this] {
    is_touched_ = true;
    return argument();
  });
  repeat_->setVisible(false);
  connect(repeat_, &RepeatRow::statusChanged, this, [this](const QString& text, bool is_bad) {
    showStatus(text, is_bad ? QStringLiteral("bad") : QStringLiteral("dim"));
  });
}

void CallPanel::showCommand(const QString& path, const MemberDescription& command,
                            const std::vector<MatchingRead>& reads) {
  if (path == path_ && command == command_) return;
  showNothing();
  path_ = path;
  command_ = command;
  reads_ = reads;
  repeat_->setCommand(path, command.expires_after);
  expiry_->setText(ExpiryText(command));
  expiry_->setVisible(command.expires_after > 0);
  takes_argument_ = TakesArgument(command.signature);
  head_->setTitle(Words::tr("Call ") + ToQString(command.name));
  head_->setToolTip(path);
  kind_->setText(ToQString(ToString(command.signature.kind)));
  as_json_->setChecked(false);
  result_->setVisible(false);
  picture_->clear();
  showStatus({}, {});
  setVisible(true);
  askForSchema();
}

void CallPanel::showNothing() {
  path_.clear();
  command_ = {};
  ++shown_;
  under_way_ = false;
  repeat_->setCommand({});
  second_key_.stop();
  setVisible(false);
}

void CallPanel::askForSchema() {
  ++shown_;
  schema_.reset();
  retry_->setVisible(false);
  argument_->setVisible(false);
  as_json_->setVisible(false);
  call_->setEnabled(!takes_argument_);
  repeat_->setCallable(!takes_argument_);
  if (!takes_argument_) return check();
  showStatus(Words::tr("Loading the argument…"), QStringLiteral("dim"));
  calls_.findSchema(path_.section('/', 0, 0).toStdString(), command_.signature.in,
                    [panel = QPointer(this), shown = shown_](const Result<Schema>& schema) {
                      if (panel != nullptr && panel->shown_ == shown) panel->onSchema(schema);
                    });
}

void CallPanel::onSchema(const Result<Schema>& schema) {
  if (!schema) {
    retry_->setVisible(true);
    return showStatus(ToQString(schema.error().message), QStringLiteral("bad"));
  }
  showStatus({}, {});
  showForm(*schema);
  check();
}

void CallPanel::showForm(const Schema& schema) {
  schema_ = schema;
  form_ = new ValueForm(schema);
  form_area_->setWidget(form_);  // deletes the previous form
  form_->setAutoFillBackground(false);
  fitForm();
  argument_->setCurrentIndex(kFormPage);
  argument_->setVisible(true);
  as_json_->setVisible(true);
  if (const auto last = last_arguments_.constFind(path_); last != last_arguments_.constEnd()) {
    form_->setJson(*last);
  } else {
    is_touched_ = false;
    askForOffer(0);
  }
  connect(form_, &ValueForm::edited, this, [this] {
    is_touched_ = true;
    fitForm();
    check();
  });
}

/// Adapts the height of the form, which changes when remarks appear below its fields.
void CallPanel::fitForm() {
  const int width = form_area_->viewport()->width();
  const int height =
      form_->hasHeightForWidth() ? form_->heightForWidth(width) : form_->sizeHint().height();
  form_area_->setFixedHeight(std::min(height, kMaxFormHeight));
  argument_->setFixedHeight(as_json_->isChecked() ? kJsonHeight : form_area_->height());
}

void CallPanel::askForOffer(std::size_t read) {
  if (read == reads_.size()) return;
  if (reads_[read].is_whole) return askForValue(reads_[read].name, {});
  calls_.findSchema(path_.section('/', 0, 0).toStdString(), reads_[read].type,
                    [panel = QPointer(this), shown = shown_, read](const Result<Schema>& offered) {
                      const bool is_wanted = panel != nullptr && panel->shown_ == shown;
                      if (is_wanted) panel->onOffer(read, offered);
                    });
}

void CallPanel::onOffer(std::size_t read, const Result<Schema>& offered) {
  const auto fields = offered ? CommonFields(*schema_, *offered) : std::vector<std::string>();
  fields.empty() ? askForOffer(read + 1) : askForValue(reads_[read].name, fields);
}

void CallPanel::askForValue(const std::string& read, const std::vector<std::string>& fields) {
  const std::string interface = path_.section('.', 0, 0).toStdString();
  calls_.readValue(interface + '.' + read, [panel = QPointer(this), shown = shown_, read,
                                            fields](const Result<std::string>& value) {
    const bool is_wanted = panel != nullptr && panel->shown_ == shown;
    if (is_wanted) panel->onValue(read, fields, value);
  });
}

/// Fills the form with `value`, the result of the read command `read`. If `fields` is not empty,
/// only these fields of the form are filled.
void CallPanel::onValue(const std::string& read, const std::vector<std::string>& fields,
                        const Result<std::string>& value) {
  if (is_touched_ || as_json_->isChecked() || under_way_) return;
  if (!value) {
    return showStatus(
        Words::tr("These are not the current values: %1 does not report the current values")
            .arg(ToQString(read)),
        QStringLiteral("warning"));
  }
  const std::string exact = WithExactDurations(*schema_, *value);
  form_->setJson(fields.empty() ? exact : WithFieldsOf(form_->json(), exact, fields));
  check();
  if (!call_->isEnabled()) return;
  QStringList names;
  for (const std::string& field : fields) names << ToQString(field);
  showStatus(names.isEmpty() ? Words::tr("Current values from %1").arg(ToQString(read))
                             : Words::tr("%1: current values from %2")
                                   .arg(names.join(QStringLiteral(", ")), ToQString(read)),
             QStringLiteral("dim"));
}

void CallPanel::showAsJson(bool as_json) {
  if (form_ == nullptr) return;
  if (as_json) {
    const std::string text = form_->json();
    json_->setPlainText(ToQString(JsonOrText(text).dump(2)));
  } else if (const std::string text = json_->toPlainText().toStdString();
             FromJson(*schema_, text)) {
    form_->setJson(text);
  } else {
    // Keeps the JSON view: the form cannot show an invalid text.
    const QSignalBlocker blocker(as_json_);
    as_json_->setChecked(true);
    return;
  }
  argument_->setCurrentIndex(as_json ? kJsonPage : kFormPage);
  fitForm();
  check();
}

std::string CallPanel::argument() const {
  if (!takes_argument_ || !schema_) return {};
  return as_json_->isChecked() ? json_->toPlainText().toStdString() : form_->json();
}

void CallPanel::check() {
  if (path_.isEmpty() || (takes_argument_ && !schema_)) return;
  QString problem = unavailable_;
  if (problem.isEmpty() && schema_) {
    const auto body = FromJson(*schema_, argument());
    if (!body) problem = problemOf(body.error());
  }
  call_->setEnabled(problem.isEmpty());
  repeat_->setCallable(problem.isEmpty());
  if (!under_way_ && !repeat_->repeater().isRunning())
    showStatus(problem, QStringLiteral("warning"));
}

/// While the form is shown, returns only the names of the wrong fields, because each field shows
/// its own error.
QString CallPanel::problemOf(const Error& error) const {
  const QStringList wrong = as_json_->isChecked() ? QStringList() : form_->wrongFields();
  if (wrong.isEmpty()) return ToQString(error.message);
  return Words::tr("To be corrected: %1").arg(wrong.join(QStringLiteral(", ")));
}

void CallPanel::setUnavailable(const QString& reason) {
  if (unavailable_ == reason) return;
  unavailable_ = reason;
  check();
}

void CallPanel::setCareful(bool careful) {
  call_->setCareful(careful);
  repeat_->setCareful(careful);
  call_->setText(careful ? Words::tr("Hold to call") : Words::tr("Call"));
  call_->setToolTip(careful ? Words::tr("This command can move something: hold the button for 0.4 "
                                        "s, or press Ctrl+Enter twice")
                            : Words::tr("Ctrl+Enter"));
}

void CallPanel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(0, 0, width(), kGap, Theme::instance().color(Token::kLine));
}

void CallPanel::callByKey() {
  is_touched_ = true;
  if (call_->isCareful() && call_->isEnabled() && !second_key_.isActive()) {
    second_key_.start();
    return showStatus(
        Words::tr("This command can move something: press Ctrl+Enter again to call it"),
        QStringLiteral("warning"));
  }
  second_key_.stop();
  call();
}

void CallPanel::call() {
  if (!call_->isEnabled() || path_.isEmpty() || under_way_) return;
  is_touched_ = true;
  const std::string said = argument();
  if (takes_argument_) last_arguments_[path_] = said;
  under_way_ = true;
  result_->setVisible(false);
  picture_->clear();
  showStatus(Words::tr("Calling…"), QStringLiteral("dim"));
  calls_.callCommand(path_.toStdString(), said,
                     [panel = QPointer(this), shown = shown_](const auto& result, double seconds) {
                       if (panel != nullptr && panel->shown_ == shown) {
                         panel->onResult(result, seconds);
                       }
                     });
}

void CallPanel::onResult(const Result<std::string>& result, double seconds) {
  under_way_ = false;
  check();
  if (!result) return showStatus(ToQString(result.error().message), QStringLiteral("bad"));
  showStatus(Words::tr("Done in ") + DurationText(seconds), QStringLiteral("ok"));
  if (result->empty()) return;
  result_->setText(Readable(*result));
  result_->setToolTip(WholeResult(*result));
  if (!LooksLikeImage(*result)) return result_->setVisible(true);
  const auto json = std::make_shared<const std::string>(*result);
  picture_->showFrom([json] { return RawImageOf(*json); });
}

void CallPanel::showStatus(const QString& text, const QString& role) {
  SetRole(*status_, role);
  status_->setText(text);
  status_->setVisible(!text.isEmpty());
}

void CallPanel::focusFirst() {
  if (!takes_argument_ || !schema_) return call_->setFocus();
  if (as_json_->isChecked()) return json_->setFocus();
  for (QWidget* const field : form_->findChildren<QWidget*>()) {
    if ((field->focusPolicy() & Qt::TabFocus) != 0) return field->setFocus();
  }
}

void CallPanel::copyCommand() const {
  QGuiApplication::clipboard()->setText(CallLine(path_, ToQString(argument())));
}

}  // namespace tendon::gui
