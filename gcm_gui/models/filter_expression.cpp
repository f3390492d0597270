#include <gcm_gui/models/filter_expression.h>

#include <tendon/base/path.h>

#include <algorithm>

namespace tendon::gui {
namespace {

/// Returns true if `text` is the kind of the item or, for a command or function, its execution
/// kind.
bool IsOfType(const CatalogueItem& item, const QString& text) {
  const CatalogueItem* it = &item;
  for (; it != nullptr && it->parent != nullptr; it = it->parent) {
    if (KindWord(it->kind).startsWith(text)) return true;
    const bool has_way = it->kind == ItemKind::kCommand || it->kind == ItemKind::kFunction;
    if (has_way && it->value.startsWith(text)) return true;
    // Stops here: processes and components contain items of all kinds, so only their own kind
    // counts.
    if (it->kind <= ItemKind::kComponent) return false;
    if (it->parent->kind <= ItemKind::kComponent) return false;
  }
  return false;
}

/// Compares with the state of the item, or of its nearest parent that has a state.
bool IsInState(const CatalogueItem& item, const QString& text) {
  const CatalogueItem* it = &item;
  while (it != nullptr && it->state.isEmpty()) it = it->parent;
  return it != nullptr && it->state.startsWith(text);
}

bool IsInProcess(const CatalogueItem& item, const QString& pattern) {
  const QString process = item.folded.section('/', 0, 0);
  if (process.startsWith(pattern)) return true;
  return MatchesGlob(pattern.toStdString(), process.toStdString());
}

bool IsOnHost(const CatalogueItem& item, const QString& pattern) {
  const CatalogueItem* it = &item;
  while (it->parent != nullptr && it->kind != ItemKind::kProcess) it = it->parent;
  if (it->host.startsWith(pattern)) return true;
  return MatchesGlob(pattern.toStdString(), it->host.toStdString());
}

bool IsExpression(const QString& word) {
  return word.size() > 2 && word.startsWith('/') && word.endsWith('/');
}

}  // namespace

FilterExpression::FilterExpression(const QString& text) {
  for (QString word : text.split(' ', Qt::SkipEmptyParts)) {
    const bool turned = word.startsWith('-');
    if (turned) word.remove(0, 1);
    Term term = Read(word);
    term.negated = term.negated != turned;
    if (!term.text.isEmpty()) terms_.push_back(std::move(term));
  }
}

FilterExpression::Term FilterExpression::Read(QString word) {
  Term term;
  if (IsExpression(word)) {
    term.text = word.mid(1, word.size() - 2);
    term.expression = QRegularExpression(term.text, QRegularExpression::CaseInsensitiveOption);
    if (term.expression.isValid()) term.kind = Kind::kExpression;
    return term;
  }
  word = word.toLower();
  constexpr std::pair<const char*, Kind> kKinds[] = {{"type:", Kind::kType},
                                                     {"state:", Kind::kState},
                                                     {"proc:", Kind::kProcess},
                                                     {"host:", Kind::kHost}};
  for (const auto& [prefix, kind] : kKinds) {
    if (!word.startsWith(QLatin1String(prefix))) continue;
    term.kind = kind;
    word.remove(0, QLatin1String(prefix).size());
  }
  if (term.kind != Kind::kWord && word.startsWith('!')) {
    term.negated = true;
    word.remove(0, 1);
  }
  term.text = word;
  return term;
}

bool FilterExpression::Holds(const Term& term, const CatalogueItem& item) {
  switch (term.kind) {
    case Kind::kWord:
      return item.folded.contains(term.text);
    case Kind::kType:
      return IsOfType(item, term.text);
    case Kind::kState:
      return IsInState(item, term.text);
    case Kind::kProcess:
      return IsInProcess(item, term.text);
    case Kind::kHost:
      return IsOnHost(item, term.text);
    case Kind::kExpression:
      return term.expression.match(item.path).hasMatch();
  }
  return false;
}

bool FilterExpression::Matches(const CatalogueItem& item) const {
  return std::all_of(terms_.begin(), terms_.end(),
                     [&](const Term& term) { return Holds(term, item) != term.negated; });
}

}  // namespace tendon::gui
