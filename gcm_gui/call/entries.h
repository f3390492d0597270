#pragma once

#include <tendon/payload/schema.h>

#include <QString>
#include <QStringList>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>

class QWidget;

namespace tendon::gui {

/// Edits one value of a type. Every input has a JSON value, valid or not. FromJson() decides
/// whether the value is valid, and rejects every input for which refusals() is not empty.
class Entry {
 public:
  Entry() = default;
  Entry(const Entry&) = delete;
  Entry& operator=(const Entry&) = delete;
  virtual ~Entry() = default;

  [[nodiscard]] virtual nlohmann::ordered_json value() const = 0;
  /// Shows a value. A value of another kind is shown unchanged if the widget can display it.
  virtual void setValue(const nlohmann::ordered_json& value) = 0;
  /// The mistakes in the input: for each mistake, one sentence that also says what to write
  /// instead.
  [[nodiscard]] virtual QStringList refusals() const { return {}; }
  /// Messages about input that was rejected, such as pasted text. The value itself is still valid.
  [[nodiscard]] virtual QStringList notices() const { return {}; }
};

/// An entry and its widget; the caller places and owns the widget.
struct EntryWidget {
  std::unique_ptr<Entry> entry;
  QWidget* widget = nullptr;
};

/// The tool tip of a field: help, range and type on separate lines.
[[nodiscard]] QString HelpOf(const Schema::Field& field);

/// Makes the editor of a field without subfields: a number, switch, choice, text or grid of
/// numbers. Lists of varying length and lists of other types are edited as JSON. `name` is the
/// accessible name of the widget. `edited` is called at each change, and when an input was refused.
[[nodiscard]] EntryWidget MakeEntry(const Schema::Field& field, const QString& name,
                                    const std::function<void()>& edited);

}  // namespace tendon::gui
