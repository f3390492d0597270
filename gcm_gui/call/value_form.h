#pragma once

#include <gcm_gui/call/entries.h>
#include <tendon/payload/schema.h>

#include <QString>
#include <QStringList>
#include <QWidget>
#include <memory>
#include <string>
#include <vector>

class QGridLayout;
class QLabel;

namespace tendon::gui {

/// A form for a value of a type, made from the type's schema: numbers with units, switches,
/// choices, and grids for vectors. Nested fields are shown below the name of their parent. Below an
/// invalid field, the form shows the mistake and what to write instead. GUI thread.
class ValueForm : public QWidget {
  Q_OBJECT

 public:
  explicit ValueForm(const Schema& schema, QWidget* parent = nullptr);
  ~ValueForm() override;

  /// Returns the present input as JSON, valid or not; FromJson() checks it.
  [[nodiscard]] std::string json() const;
  /// Fills the form from a value. Parts of the value without a field in this form are ignored.
  void setJson(const std::string& json);
  /// The names of the fields with invalid input: "position", "frame.parent".
  [[nodiscard]] QStringList wrongFields() const;

 Q_SIGNALS:
  void edited();

 private:
  class Structure;

  struct FormField {
    QString name;
    const Entry* entry;
    QLabel* refusals;
  };

  std::unique_ptr<Entry> addFields(const Schema::Field& structure, const QString& path, int level);
  std::unique_ptr<Entry> addField(const Schema::Field& field, const QString& path, int level);
  void onEdited();
  void showRefusals();
  void addName(const Schema::Field& field, const QString& text, int level);

  const Schema schema_;
  QGridLayout* grid_;
  std::unique_ptr<Entry> entry_;
  std::vector<FormField> form_fields_;  // one for each field without subfields
  bool is_filling_ = false;             // setJson() is filling the fields
  bool has_changed_ = false;            // a field changed during setJson()
};

}  // namespace tendon::gui
