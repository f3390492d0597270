#include <gcm_gui/commands/palette_model.h>

#include <gcm_gui/commands/commands.h>
#include <gcm_gui/models/row_roles.h>

#include <QAction>
#include <algorithm>
#include <tuple>
#include <utility>

namespace tendon::gui {
namespace {

bool HasAll(const QString& folded, const QStringList& words) {
  return std::all_of(words.begin(), words.end(),
                     [&](const QString& word) { return folded.contains(word); });
}

constexpr qsizetype kWidest = 3;  // the letters may span this many times the length of the word

/// Returns true if the letters of `word` occur in this order and close together.
bool IsScattered(const QString& folded, const QString& word) {
  for (qsizetype first = folded.indexOf(word[0]); first >= 0;
       first = folded.indexOf(word[0], first + 1)) {
    qsizetype at = first;
    for (qsizetype i = 1; i < word.size() && at >= 0; ++i) at = folded.indexOf(word[i], at + 1);
    if (at < 0) return false;
    if (at - first < kWidest * word.size()) return true;
  }
  return false;
}

enum class Likeness { kNone, kNearly, kWholly };

/// Returns how well the words match. kNearly means that for at least one word only its letters were
/// found, in the same order.
Likeness LikenessOf(const QString& folded, const QStringList& words) {
  if (HasAll(folded, words)) return Likeness::kWholly;
  const bool is_near = std::all_of(words.begin(), words.end(), [&](const QString& word) {
    return folded.contains(word) || IsScattered(folded, word);
  });
  return is_near ? Likeness::kNearly : Likeness::kNone;
}

struct ObjectMatch {
  const CatalogueItem* item;
  int rank;  // best first

  [[nodiscard]] auto key() const { return std::tuple(rank, item->folded.size(), item->folded); }
};

/// Ranks a match: the word is the name itself (best), the beginning of the name, or elsewhere.
int RankOf(const CatalogueItem& item, const QStringList& words) {
  const QStringView name =
      QStringView(item.folded).last(std::min(item.name.size(), item.folded.size()));
  if (name == words.last()) return 0;
  return name.startsWith(words.last()) ? 1 : 2;
}

/// The matches of one quality.
struct Matches {
  std::vector<QAction*> actions;
  std::vector<ObjectMatch> things;

  [[nodiscard]] bool isEmpty() const { return actions.empty() && things.empty(); }
};

/// The matches of both qualities, found in one pass.
struct AllMatches {
  Matches wholly;
  Matches nearly;

  /// Returns the list for this quality; null for kNone.
  [[nodiscard]] Matches* of(Likeness likeness) {
    if (likeness == Likeness::kNone) return nullptr;
    return likeness == Likeness::kWholly ? &wholly : &nearly;
  }
};

void Collect(const CatalogueItem& item, const QStringList& words, AllMatches& finds) {
  if (Matches* same = finds.of(LikenessOf(item.folded, words))) {
    same->things.push_back({&item, RankOf(item, words)});
  }
  for (const auto& child : item.children) Collect(*child, words, finds);
}

std::vector<PaletteRow> RowsOf(Matches finds) {
  std::vector<PaletteRow> rows;
  for (QAction* action : finds.actions) {
    rows.push_back(
        {action, PlainText(*action), action->shortcut().toString(QKeySequence::NativeText)});
  }
  auto& things = finds.things;
  const auto shown = things.begin() +
                     static_cast<std::ptrdiff_t>(std::min(things.size(), PaletteModel::kMaxThings));
  std::partial_sort(things.begin(), shown, things.end(),
                    [](const ObjectMatch& a, const ObjectMatch& b) { return a.key() < b.key(); });
  for (auto it = things.begin(); it != shown; ++it) {
    rows.push_back({nullptr, it->item->path, KindWord(it->item->kind)});
  }
  return rows;
}

}  // namespace

PaletteModel::PaletteModel(QList<QAction*> actions, const CatalogueModel& catalogue,
                           QObject* parent)
    : RowListModel(parent), actions_(std::move(actions)), catalogue_(catalogue) {}

void PaletteModel::find(const QString& words) {
  const QStringList wanted = words.toLower().split(' ', Qt::SkipEmptyParts);
  AllMatches finds;
  for (QAction* action : actions_) {
    if (!action->isEnabled()) continue;
    if (Matches* same = finds.of(LikenessOf(PlainText(*action).toLower(), wanted))) {
      same->actions.push_back(action);
    }
  }
  for (int row = 0; row < catalogue_.rowCount({}) && !wanted.isEmpty(); ++row) {
    Collect(*catalogue_.item(catalogue_.index(row, 0, {})), wanted, finds);
  }
  showRows(RowsOf(std::move(finds.wholly.isEmpty() ? finds.nearly : finds.wholly)));
}

QVariant PaletteModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const PaletteRow& row = this->row(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return row.text;
    case kFontStyleRole:
      return static_cast<int>(row.action != nullptr ? FontStyle::kPlain : FontStyle::kMono);
    case kTrailRole:
      return row.trail;
    case kPathRole:
      return row.action != nullptr ? QString() : row.text;
    case Qt::AccessibleTextRole:
      return row.text + ' ' + row.trail;
    default:
      return {};
  }
}

}  // namespace tendon::gui
