#include <gcm_gui/call/entries.h>

#include <gcm_gui/call/number_field.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <tendon/payload/json.h>
#include <tendon/payload/json/strict_json.h>
#include <tendon/payload/json/typed_value.h>
#include <tendon/payload/schema/range.h>

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLineEdit>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace tendon::gui {
namespace {

using Json = nlohmann::ordered_json;
using Edited = std::function<void()>;

constexpr std::uint32_t kMaxCells = 16;
constexpr int kCellsInRow = 4;
constexpr int kMinCell = 40;

QString EntryText(const Json& value) {
  return ToQString(value.is_string() ? value.get<std::string>() : value.dump());
}

QLineEdit* MakeLine(const QString& name, const Edited& edited) {
  auto* line = new QLineEdit;
  SetRole(*line, QStringLiteral("mono"));
  line->setAccessibleName(name);
  QObject::connect(line, &QLineEdit::textChanged, line, [edited] { edited(); });
  return line;
}

class NumberEntry final : public Entry {
 public:
  explicit NumberEntry(NumberField& field) : field_(field) {}

  /// Returns an invalid number as text.
  [[nodiscard]] Json value() const override {
    const NumberLiteral word = field_.word();
    if (word.flaw != NumberFlaw::kNone) return field_.text().toStdString();
    const bool is_fine = field_.isDuration() && IsFinerThanDouble(word.json);
    return is_fine ? Json(word.json) : *ParseOrderedJson(word.json);
  }
  void setValue(const Json& value) override { field_.setText(EntryText(value)); }
  [[nodiscard]] QStringList refusals() const override {
    const QString refusal = field_.refusal();
    return refusal.isEmpty() ? QStringList() : QStringList(refusal);
  }
  [[nodiscard]] QStringList notices() const override {
    const QString& notice = field_.pasteRefusal();
    return notice.isEmpty() ? QStringList() : QStringList(notice);
  }

 private:
  NumberField& field_;
};

/// Edits a value as JSON text.
class JsonEntry final : public Entry {
 public:
  JsonEntry(const Schema& schema, const QString& name, QLineEdit& line)
      : schema_(schema), name_(name.toStdString()), line_(line) {}

  /// Returns invalid JSON as text.
  [[nodiscard]] Json value() const override {
    const auto value = typed();
    return value ? *value : Json(line_.text().toStdString());
  }
  void setValue(const Json& value) override { line_.setText(EntryText(value)); }
  [[nodiscard]] QStringList refusals() const override {
    const auto value = typed();
    if (!value) return {ToQString(value.error().message)};
    const auto body = FromJson(schema_, value->dump());
    return body ? QStringList() : QStringList(ToQString(body.error().message));
  }

 private:
  [[nodiscard]] Result<Json> typed() const {
    return TypedValue(schema_, name_, line_.text().trimmed().toStdString());
  }

  const Schema schema_;
  const std::string name_;
  QLineEdit& line_;
};

class TextEntry final : public Entry {
 public:
  explicit TextEntry(QLineEdit& line) : line_(line) {}

  [[nodiscard]] Json value() const override { return line_.text().toStdString(); }
  void setValue(const Json& value) override { line_.setText(EntryText(value)); }

 private:
  QLineEdit& line_;
};

class SwitchEntry final : public Entry {
 public:
  explicit SwitchEntry(QCheckBox& box) : box_(box) {}

  [[nodiscard]] Json value() const override { return box_.isChecked(); }
  void setValue(const Json& value) override { box_.setChecked(value == true); }

 private:
  QCheckBox& box_;
};

class ChoiceEntry final : public Entry {
 public:
  explicit ChoiceEntry(QComboBox& box) : box_(box) {}

  [[nodiscard]] Json value() const override { return box_.currentText().toStdString(); }
  void setValue(const Json& value) override { box_.setCurrentText(EntryText(value)); }

 private:
  QComboBox& box_;
};

class ListEntry final : public Entry {
 public:
  explicit ListEntry(std::vector<std::unique_ptr<Entry>> elements)
      : elements_(std::move(elements)) {}

  [[nodiscard]] Json value() const override {
    Json list = Json::array();
    for (const auto& element : elements_) list.push_back(element->value());
    return list;
  }
  void setValue(const Json& value) override {
    if (!value.is_array()) return;
    for (std::size_t i = 0; i < std::min(value.size(), elements_.size()); ++i) {
      elements_[i]->setValue(value[i]);
    }
  }
  [[nodiscard]] QStringList refusals() const override { return OfAll(&Entry::refusals); }
  [[nodiscard]] QStringList notices() const override { return OfAll(&Entry::notices); }

 private:
  /// Puts the index before each sentence: "[2]: write 0.5: use a point as the decimal sign".
  [[nodiscard]] QStringList OfAll(QStringList (Entry::*sentences)() const) const {
    QStringList all;
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      for (const QString& one : (*elements_[i].*sentences)()) {
        all << QStringLiteral("[%1]: %2").arg(i).arg(one);
      }
    }
    return all;
  }

  std::vector<std::unique_ptr<Entry>> elements_;
};

/// Returns the allowed number that is closest to 0. It has all digits, because a rounded number
/// might be out of range.
QString FirstNumber(const Schema::Field& field) {
  if (!field.range) return QStringLiteral("0");
  double number = std::clamp(0.0, field.range->lowest, field.range->highest);
  const Schema& schema =
      field.schema.kind() == Schema::Kind::kArray ? field.schema.element() : field.schema;
  const bool is_integer = schema.is_number() && schema.kind() < Schema::Kind::kFloat32;
  if (is_integer) number = number > 0 ? std::ceil(number) : std::floor(number);
  std::array<char, 32> digits{};
  const auto end =
      is_integer ? std::to_chars(digits.begin(), digits.end(), number, std::chars_format::fixed).ptr
                 : std::to_chars(digits.begin(), digits.end(), number).ptr;
  return QString::fromLatin1(digits.data(), end - digits.data());
}

NumberField* MakeNumberField(const Schema::Field& field, const QString& name,
                             const Edited& edited) {
  auto* number = new NumberField(field);
  number->setAccessibleName(name);
  number->setText(FirstNumber(field));
  QObject::connect(number, &QLineEdit::textChanged, number, [edited] { edited(); });
  QObject::connect(number, &NumberField::pasteRefused, number, [edited] { edited(); });
  return number;
}

EntryWidget MakeNumber(const Schema::Field& field, const QString& name, const Edited& edited) {
  NumberField* number = MakeNumberField(field, name, edited);
  number->setHelp(HelpOf(field));
  return {std::make_unique<NumberEntry>(*number), number};
}

EntryWidget MakeSwitch(const QString& name, const Edited& edited) {
  auto* box = new QCheckBox;
  box->setAccessibleName(name);
  QObject::connect(box, &QCheckBox::toggled, box, [edited] { edited(); });
  return {std::make_unique<SwitchEntry>(*box), box};
}

EntryWidget MakeChoice(const Schema& schema, const QString& name, const Edited& edited) {
  auto* box = new QComboBox;
  box->setAccessibleName(name);
  for (const auto& one : schema.enumerators()) box->addItem(ToQString(one.name));
  QObject::connect(box, &QComboBox::currentIndexChanged, box, [edited] { edited(); });
  return {std::make_unique<ChoiceEntry>(*box), box};
}

EntryWidget MakeGrid(const Schema::Field& field, const QString& name, const Edited& edited) {
  auto* widget = new QWidget;
  auto* grid = new QGridLayout(widget);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(kGrid);
  std::vector<std::unique_ptr<Entry>> elements;
  QList<NumberField*> cells;
  for (std::uint32_t i = 0; i < field.schema.length(); ++i) {
    const auto place = static_cast<int>(i);
    NumberField* cell =
        MakeNumberField(field, QStringLiteral("%1[%2]").arg(name).arg(place), edited);
    cell->setHelp(QStringLiteral("[%1]").arg(place));
    cell->setMinimumWidth(kMinCell);
    grid->addWidget(cell, place / kCellsInRow, place % kCellsInRow);
    elements.push_back(std::make_unique<NumberEntry>(*cell));
    cells.append(cell);
  }
  for (int column = 0; column < kCellsInRow; ++column) grid->setColumnStretch(column, 1);
  for (qsizetype i = 0; i < cells.size(); ++i) cells[i]->setRow(cells.mid(i));
  return {std::make_unique<ListEntry>(std::move(elements)), widget};
}

EntryWidget MakeText(const QString& name, const Edited& edited) {
  QLineEdit* line = MakeLine(name, edited);
  return {std::make_unique<TextEntry>(*line), line};
}

EntryWidget MakeJson(const Schema& schema, const QString& name, const Edited& edited) {
  QLineEdit* line = MakeLine(name, edited);
  line->setText(QStringLiteral("[]"));
  line->setToolTip(Words::tr("JSON of ") + ToQString(schema.TypeName()));
  return {std::make_unique<JsonEntry>(schema, name, *line), line};
}

}  // namespace

QString HelpOf(const Schema::Field& field) {
  QStringList lines;
  if (!field.help.empty()) lines << ToQString(field.help);
  if (field.range) {
    lines << (ToQString(payload::ToString(*field.range)) + ' ' + ToQString(field.unit)).trimmed();
  }
  lines << ToQString(field.schema.TypeName());
  return lines.join('\n');
}

EntryWidget MakeEntry(const Schema::Field& field, const QString& name, const Edited& edited) {
  const Schema& schema = field.schema;
  if (IsWrittenAsNumber(schema.kind())) return MakeNumber(field, name, edited);
  switch (schema.kind()) {
    case Schema::Kind::kBool:
      return MakeSwitch(name, edited);
    case Schema::Kind::kEnum:
      return MakeChoice(schema, name, edited);
    case Schema::Kind::kString:
      return MakeText(name, edited);
    case Schema::Kind::kArray:
      if (IsWrittenAsNumber(schema.element().kind()) && schema.length() <= kMaxCells) {
        return MakeGrid(field, name, edited);
      }
      break;
    default:
      break;
  }
  return MakeJson(schema, name, edited);
}

}  // namespace tendon::gui
