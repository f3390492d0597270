#include <gcm_gui/call/entries.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <tendon/payload/json/strict_json.h>

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QRegularExpression>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace tendon::gui {
namespace {

using Json = nlohmann::ordered_json;
using Edited = std::function<void()>;

constexpr std::uint32_t kMostCells = 16;
constexpr int kCellsInRow = 4;
constexpr int kLeastCell = 40;

QString TextOf(const Json& value) {
  return ToQString(value.is_string() ? value.get<std::string>() : value.dump());
}

/// What is no JSON stays a text.
Json Understood(const QString& text) {
  const std::string trimmed = text.trimmed().toStdString();
  const auto value = ParseOrderedJson(trimmed);
  return value ? *value : Json(trimmed);
}

QLineEdit* MakeLine(const QString& name, const Edited& edited) {
  auto* line = new QLineEdit;
  SetRole(*line, QStringLiteral("mono"));
  line->setAccessibleName(name);
  QObject::connect(line, &QLineEdit::textChanged, line, [edited] { edited(); });
  return line;
}

/// A number, or anything else that is written as JSON.
class JsonEntry final : public Entry {
 public:
  explicit JsonEntry(QLineEdit& line) : line_(line) {}

  [[nodiscard]] Json value() const override { return Understood(line_.text()); }
  void setValue(const Json& value) override { line_.setText(TextOf(value)); }

 private:
  QLineEdit& line_;
};

class TextEntry final : public Entry {
 public:
  explicit TextEntry(QLineEdit& line) : line_(line) {}

  [[nodiscard]] Json value() const override { return line_.text().toStdString(); }
  void setValue(const Json& value) override { line_.setText(TextOf(value)); }

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
  void setValue(const Json& value) override { box_.setCurrentText(TextOf(value)); }

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

 private:
  std::vector<std::unique_ptr<Entry>> elements_;
};

/// The number closest to 0 that is allowed.
double FirstNumber(const Schema::Field& field) {
  return field.range ? std::clamp(0.0, field.range->lowest, field.range->highest) : 0.0;
}

EntryWidget MakeNumber(const Schema::Field& field, const QString& name, const Edited& edited) {
  QLineEdit* line = MakeLine(name, edited);
  line->setAlignment(Qt::AlignRight);
  line->setText(NumberText(FirstNumber(field)));
  return {std::make_unique<JsonEntry>(*line), line};
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

bool IsNumber(const Schema& schema) {
  return schema.kind() != Schema::Kind::kBool &&
         (schema.is_number() || schema.kind() == Schema::Kind::kDuration);
}

/// Numbers that were copied from anywhere, into one cell, fill it and those behind it.
void SpreadPastedNumbers(const std::vector<QLineEdit*>& cells, std::size_t first) {
  static const QRegularExpression between(QStringLiteral("[\\s,;\\[\\]]+"));
  const QStringList words = cells[first]->text().split(between, Qt::SkipEmptyParts);
  if (words.size() < 2) return;
  for (qsizetype i = 0; i < words.size() && first < cells.size(); ++i, ++first) {
    cells[first]->setText(words[i]);
  }
}

EntryWidget MakeGrid(const Schema::Field& field, const QString& name, const Edited& edited) {
  auto* widget = new QWidget;
  auto* grid = new QGridLayout(widget);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(kGrid);
  std::vector<std::unique_ptr<Entry>> elements;
  std::vector<QLineEdit*> cells;
  for (std::uint32_t i = 0; i < field.schema.length(); ++i) {
    auto [entry, cell] = MakeNumber(field, QStringLiteral("%1[%2]").arg(name).arg(i), edited);
    cells.push_back(static_cast<QLineEdit*>(cell));
    cell->setToolTip(QStringLiteral("[%1]").arg(i));
    cell->setMinimumWidth(kLeastCell);
    const auto place = static_cast<int>(i);
    grid->addWidget(cell, place / kCellsInRow, place % kCellsInRow);
    elements.push_back(std::move(entry));
  }
  for (int column = 0; column < kCellsInRow; ++column) grid->setColumnStretch(column, 1);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    QObject::connect(cells[i], &QLineEdit::textChanged, widget,
                     [cells, i, size = cells[i]->text().size()](const QString& text) mutable {
                       const bool is_typed = text.size() == std::exchange(size, text.size()) + 1;
                       if (!is_typed) SpreadPastedNumbers(cells, i);
                     });
  }
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
  return {std::make_unique<JsonEntry>(*line), line};
}

}  // namespace

EntryWidget MakeEntry(const Schema::Field& field, const QString& name, const Edited& edited) {
  const Schema& schema = field.schema;
  if (IsNumber(schema)) return MakeNumber(field, name, edited);
  switch (schema.kind()) {
    case Schema::Kind::kBool:
      return MakeSwitch(name, edited);
    case Schema::Kind::kEnum:
      return MakeChoice(schema, name, edited);
    case Schema::Kind::kString:
      return MakeText(name, edited);
    case Schema::Kind::kArray:
      if (IsNumber(schema.element()) && schema.length() <= kMostCells) {
        return MakeGrid(field, name, edited);
      }
      break;
    default:
      break;
  }
  return MakeJson(schema, name, edited);
}

}  // namespace tendon::gui
