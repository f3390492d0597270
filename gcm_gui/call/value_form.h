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

/// Fields in which a value of a type is entered, made from its schema: numbers with their units,
/// switches, choices, grids for vectors; what is nested stands below its name. What is wrong with a
/// field stands below it, with what to write instead. GUI thread.
class ValueForm : public QWidget {
  Q_OBJECT

 public:
  explicit ValueForm(const Schema& schema, QWidget* parent = nullptr);
  ~ValueForm() override;

  /// What is entered, right or wrong: FromJson() tells.
  [[nodiscard]] std::string json() const;
  /// Shows as much of a value as there are fields for.
  void setJson(const std::string& json);
  /// The names of the fields that hold no value of their types: "position", "frame.parent".
  [[nodiscard]] QStringList wrongFields() const;

 Q_SIGNALS:
  void edited();

 private:
  class Structure;

  struct Place {
    QString name;
    const Entry* entry;
    QLabel* refusals;
  };

  std::unique_ptr<Entry> addFields(const Schema::Field& structure, const QString& path, int level);
  std::unique_ptr<Entry> addField(const Schema::Field& field, const QString& path, int level);
  void hearEdit();
  void showRefusals();
  void addName(const Schema::Field& field, const QString& text, int level);

  const Schema schema_;
  QGridLayout* grid_;
  std::unique_ptr<Entry> entry_;
  std::vector<Place> places_;  // of all that has no fields of its own
};

}  // namespace tendon::gui
