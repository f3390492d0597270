#pragma once

#include <gcm_gui/models/catalogue_item.h>

#include <QRegularExpression>
#include <QString>
#include <vector>

namespace tendon::gui {

/// A filter as the user types it. Every word must occur in the path, in any order; `-word` must
/// not. `type:command` and `state:active` test the kind and state of a row or of its parents,
/// `proc:arm*` its process, `host:robot1` the host of the process; `-`, or `!` after the colon,
/// negates a test. `/expression/` is a regular expression that the path must match, ignoring case.
class FilterExpression {
 public:
  FilterExpression() = default;
  explicit FilterExpression(const QString& text);

  [[nodiscard]] bool empty() const { return terms_.empty(); }
  /// True if the row itself matches, regardless of its parents and children.
  [[nodiscard]] bool Matches(const CatalogueItem& item) const;

 private:
  enum class Kind { kWord, kType, kState, kProcess, kHost, kExpression };
  struct Term {
    Kind kind = Kind::kWord;
    QString text;
    QRegularExpression expression;
    bool negated = false;
  };

  /// `word` without a `-`.
  [[nodiscard]] static Term Read(QString word);
  [[nodiscard]] static bool Holds(const Term& term, const CatalogueItem& item);

  std::vector<Term> terms_;
};

}  // namespace tendon::gui
