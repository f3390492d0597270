#pragma once

#include <gcm_gui/models/catalogue_item.h>

#include <QRegularExpression>
#include <QString>
#include <vector>

namespace tendon::gui {

/// What a user types to find rows: words that must all be in the path, in any order. `-word` must
/// not be; `type:command` and `state:active` look at what it is and how it is (or what it belongs
/// to), `proc:arm*` at its process, `host:robot1` at where that runs; `-` and, after the colon, `!`
/// turn each around. `/expression/` is a regular expression that the path has to have, whatever its
/// case.
class FilterExpression {
 public:
  FilterExpression() = default;
  explicit FilterExpression(const QString& text);

  [[nodiscard]] bool empty() const { return terms_.empty(); }
  /// Whether the row itself is meant, whatever is above and below it.
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
