#pragma once

#include <gcm_gui/call/entries.h>
#include <tendon/payload/schema.h>

#include <QString>
#include <QWidget>
#include <memory>
#include <string>

class QGridLayout;

namespace tendon::gui {

/// Fields in which a value of a type is entered, made from its schema: numbers with their units,
/// switches, choices, grids for vectors; what is nested stands below its name. GUI thread.
class ValueForm : public QWidget {
  Q_OBJECT

 public:
  explicit ValueForm(const Schema& schema, QWidget* parent = nullptr);
  ~ValueForm() override;

  /// What is entered, right or wrong: FromJson() tells.
  [[nodiscard]] std::string json() const;
  /// Shows as much of a value as there are fields for.
  void setJson(const std::string& json);

 Q_SIGNALS:
  void edited();

 private:
  class Structure;

  std::unique_ptr<Entry> addFields(const Schema& structure, const QString& path, int level);
  std::unique_ptr<Entry> addField(const Schema::Field& field, const QString& path, int level);
  void addName(const Schema::Field& field, const QString& text, int level);

  QGridLayout* grid_;
  std::unique_ptr<Entry> entry_;
};

}  // namespace tendon::gui
