#pragma once

#include <gcm_gui/models/catalogue_item.h>

#include <QRegularExpression>
#include <QString>
#include <vector>

namespace tendon::gui {

/// A filter as the user types it. Every word must occur in the path, in any order; with `-word`,
/// the word must not occur. `type:command` and `state:active` test the kind and the state of a row
/// or of its parents. `proc:arm*` tests the process of the row, `host:robot1` the host of this
/// process. A `-` before a test, or a `!` after its colon, negates the test. `/expression/` is a
/// regular expression that the path must match, ignoring case.
class FilterExpression {
 public:
  FilterExpression() = default;
  explicit FilterExpression(const QString& text);

  [[nodiscard]] bool empty() const { return terms_.empty(); }
  /// Returns true if the row itself matches, whether or not its parents and children do.
  [[nodiscard]] bool Matches(const CatalogueItem& item) const;

 private:
  enum class Kind { kWord, kType, kState, kProcess, kHost, kExpression };
  struct Term {
    Kind kind = Kind::kWord;
    QString text;
    QRegularExpression expression;
    bool negated = false;
  };

  /// Parses a word without its leading `-`.
  [[nodiscard]] static Term Read(QString word);
  [[nodiscard]] static bool Holds(const Term& term, const CatalogueItem& item);

  std::vector<Term> terms_;
};

}  // namespace tendon::gui
