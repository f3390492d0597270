#pragma once

#include <tendon/payload/schema.h>

#include <QString>
#include <QStringList>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>

class QWidget;

namespace tendon::gui {

/// The editor of one value of a type. Every input has a JSON value, valid or not. FromJson()
/// decides whether it is valid, and rejects everything that refusals() reports.
class Entry {
 public:
  Entry() = default;
  Entry(const Entry&) = delete;
  Entry& operator=(const Entry&) = delete;
  virtual ~Entry() = default;

  [[nodiscard]] virtual nlohmann::ordered_json value() const = 0;
  /// Shows a value. One of another kind is shown unchanged if the widget can display it.
  virtual void setValue(const nlohmann::ordered_json& value) = 0;
  /// The mistakes in the input, each with what to write instead: one sentence for the user each.
  [[nodiscard]] virtual QStringList refusals() const { return {}; }
  /// Messages about input that was not accepted, so that the value is still valid.
  [[nodiscard]] virtual QStringList notices() const { return {}; }
};

/// An entry and its widget; the caller places and owns the widget.
struct EntryWidget {
  std::unique_ptr<Entry> entry;
  QWidget* widget = nullptr;
};

/// The tool tip of a field: its help, range and type, one line each.
[[nodiscard]] QString HelpOf(const Schema::Field& field);

/// The editor of a field without subfields: a number, switch, choice, text or grid of numbers; JSON
/// for lists of varying length and lists of other things. `name` is its accessible name. `edited`
/// is called at each change, and when an input was refused.
[[nodiscard]] EntryWidget MakeEntry(const Schema::Field& field, const QString& name,
                                    const std::function<void()>& edited);

}  // namespace tendon::gui
