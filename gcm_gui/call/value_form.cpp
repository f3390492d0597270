#include <gcm_gui/call/value_form.h>

#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <tendon/payload/json/strict_json.h>
#include <tendon/payload/json/typed_value.h>

#include <QGridLayout>
#include <QLabel>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace tendon::gui {
namespace {

using Json = nlohmann::ordered_json;

enum Column { kNameColumn, kEntryColumn, kUnitColumn, kFormColumns };

/// Returns `field`. If it has no unit or no range, it gets the unit or the range of `outer`.
Schema::Field Within(const Schema::Field& outer, Schema::Field field) {
  if (field.unit.empty()) field.unit = outer.unit;
  if (!field.range) field.range = outer.range;
  return field;
}

}  // namespace

class ValueForm::Structure final : public Entry {
 public:
  void add(std::string name, std::unique_ptr<Entry> entry) {
    fields_.emplace_back(std::move(name), std::move(entry));
  }

  [[nodiscard]] Json value() const override {
    Json object = Json::object();
    for (const auto& [name, entry] : fields_) object[name] = entry->value();
    return object;
  }
  void setValue(const Json& value) override {
    if (!value.is_object()) return;
    for (const auto& [name, entry] : fields_) {
      if (const auto found = value.find(name); found != value.end()) entry->setValue(*found);
    }
  }

 private:
  std::vector<std::pair<std::string, std::unique_ptr<Entry>>> fields_;
};

ValueForm::ValueForm(const Schema& schema, QWidget* parent)
    : QWidget(parent), schema_(schema), grid_(new QGridLayout(this)) {
  grid_->setContentsMargins(kInset, kGrid, kInset, kGrid);
  grid_->setHorizontalSpacing(2 * kGrid);
  grid_->setVerticalSpacing(kGrid);
  grid_->setColumnStretch(kEntryColumn, 1);
  const bool has_fields = schema.kind() == Schema::Kind::kStructure;
  const Schema::Field whole{.name = "value", .unit = {}, .schema = schema};
  entry_ = has_fields ? addFields(whole, {}, 0) : addField(whole, {}, 0);
  showRefusals();
}

ValueForm::~ValueForm() = default;

std::string ValueForm::json() const { return entry_->value().dump(); }

void ValueForm::setJson(const std::string& json) {
  const auto value = ParseOrderedJson(WithExactDurations(schema_, json));
  if (!value) return;
  // setValue() makes each field report a change. These reports are suppressed, and one report is
  // sent for all fields.
  is_filling_ = true;
  entry_->setValue(*value);
  is_filling_ = false;
  if (std::exchange(has_changed_, false)) onEdited();
}

QStringList ValueForm::wrongFields() const {
  QStringList names;
  for (const FormField& field : form_fields_) {
    if (!field.entry->refusals().isEmpty()) names << field.name;
  }
  return names;
}

void ValueForm::onEdited() {
  if (is_filling_) {
    has_changed_ = true;
    return;
  }
  showRefusals();
  Q_EMIT edited();
}

void ValueForm::showRefusals() {
  for (const FormField& field : form_fields_) {
    const QStringList sentences = field.entry->notices() + field.entry->refusals();
    field.refusals->setText(sentences.join('\n'));
    field.refusals->setVisible(!sentences.isEmpty());
  }
}

std::unique_ptr<Entry> ValueForm::addFields(const Schema::Field& structure, const QString& path,
                                            int level) {
  auto entry = std::make_unique<Structure>();
  for (const auto& field : structure.schema.fields()) {
    entry->add(field.name, addField(Within(structure, field), path, level));
  }
  return entry;
}

std::unique_ptr<Entry> ValueForm::addField(const Schema::Field& field, const QString& path,
                                           int level) {
  const QString name = ToQString(field.name);
  const QString whole = path.isEmpty() ? name : path + '.' + name;
  addName(field, name, level);
  const int row = grid_->rowCount() - 1;
  if (field.schema.kind() == Schema::Kind::kStructure) {
    return addFields(field, whole, level + 1);
  }
  auto [entry, widget] = MakeEntry(field, whole, [this] { onEdited(); });
  widget->setObjectName(QStringLiteral("form.") + whole);
  if (widget->toolTip().isEmpty()) widget->setToolTip(HelpOf(field));
  const bool is_wide = field.schema.kind() == Schema::Kind::kArray;
  is_wide ? grid_->addWidget(widget, row + 1, kNameColumn, 1, kFormColumns)
          : grid_->addWidget(widget, row, kEntryColumn);
  auto* refusals = new QLabel;
  refusals->setObjectName(QStringLiteral("refusals.") + whole);
  refusals->setTextFormat(Qt::PlainText);
  refusals->setWordWrap(true);
  SetRole(*refusals, QStringLiteral("bad"));
  grid_->addWidget(refusals, row + (is_wide ? 2 : 1), kNameColumn, 1, kFormColumns);
  form_fields_.push_back({.name = whole, .entry = entry.get(), .refusals = refusals});
  return std::move(entry);
}

void ValueForm::addName(const Schema::Field& field, const QString& text, int level) {
  const int row = grid_->rowCount();
  auto* name = new QLabel(text);
  name->setContentsMargins(level * kIndent, 0, 0, 0);
  name->setMinimumHeight(kRowHeight);
  name->setToolTip(HelpOf(field));
  SetRole(*name, QStringLiteral("dim"));
  grid_->addWidget(name, row, kNameColumn);
  if (field.unit.empty()) return;
  auto* unit = new QLabel(ToQString(field.unit));
  SetRole(*unit, QStringLiteral("dim mono"));
  grid_->addWidget(unit, row, kUnitColumn);
}

}  // namespace tendon::gui
