#pragma once

#include <tendon/payload/schema.h>

#include <QString>
#include <QStringList>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>

class QWidget;

namespace tendon::gui {

/// Where one value of a type is entered. Whatever is entered has a JSON value, right or wrong:
/// FromJson() is the judge, and refuses all that refusals() finds.
class Entry {
 public:
  Entry() = default;
  Entry(const Entry&) = delete;
  Entry& operator=(const Entry&) = delete;
  virtual ~Entry() = default;

  [[nodiscard]] virtual nlohmann::ordered_json value() const = 0;
  /// A value of another kind is shown as it is, where there is room for it.
  virtual void setValue(const nlohmann::ordered_json& value) = 0;
  /// What is wrong with it, and what to write instead, each a sentence for the user.
  [[nodiscard]] virtual QStringList refusals() const { return {}; }
  /// What was not taken into it, so that nothing is wrong with its value.
  [[nodiscard]] virtual QStringList notices() const { return {}; }
};

/// An entry and the widget that the user sees, which the caller places and owns.
struct EntryWidget {
  std::unique_ptr<Entry> entry;
  QWidget* widget = nullptr;
};

/// What is said of a field beside its name: its help, its range, its type; a line each.
[[nodiscard]] QString HelpOf(const Schema::Field& field);

/// For whatever has no fields of its own: a number, a switch, a choice, a text, a grid of numbers;
/// JSON for lists of varying length and of anything but numbers. `name` is what it is called by who
/// cannot see it; `edited` is called at each change, and where one was refused.
[[nodiscard]] EntryWidget MakeEntry(const Schema::Field& field, const QString& name,
                                    const std::function<void()>& edited);

}  // namespace tendon::gui
