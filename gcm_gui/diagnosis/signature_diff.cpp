#include <gcm_gui/diagnosis/signature_diff.h>

#include <gcm_gui/language/words.h>
#include <tendon/base/name.h>

#include <algorithm>
#include <utility>

namespace tendon::gui {
namespace {

using Verdict = SignatureRow::Verdict;
using Members = std::vector<MemberDescription>;

const MemberDescription* Find(const Members& members, const std::string& name) {
  const auto it =
      std::ranges::find_if(members, [&](const auto& member) { return member.name == name; });
  return it == members.end() ? nullptr : &*it;
}

/// Returns the names in `members` that are not in `others`.
std::vector<std::string> NamesBut(const Members& members, const Members& others) {
  std::vector<std::string> names;
  for (const auto& member : members) {
    if (Find(others, member.name) == nullptr) names.push_back(member.name);
  }
  return names;
}

class Diff {
 public:
  explicit Diff(Compatibility compatibility) : compatibility_(std::move(compatibility)) {}

  void AddNeeded(const Members& needed, const Members& offered, bool are_events) {
    for (const auto& member : needed) {
      SignatureRow row{Verdict::kSame, are_events, &member, Find(offered, member.name), {}};
      if (row.offered == nullptr) {
        row.verdict = member.optional ? Verdict::kWithout : Verdict::kMissing;
        row.remark = (member.optional ? Words::tr("optional, not offered") : Words::tr("missing"))
                         .toStdString() +
                     DidYouMean(member.name, NamesBut(offered, needed));
      } else if (row.offered->signature != member.signature) {
        row.verdict = Verdict::kChanged;
        row.remark = WordsOf(member.name);
      }
      rows_.push_back(std::move(row));
    }
  }

  void AddUnneeded(const Members& needed, const Members& offered, bool are_events) {
    for (const auto& member : offered) {
      if (Find(needed, member.name) != nullptr) continue;
      rows_.push_back({Verdict::kUnneeded, are_events, nullptr, &member,
                       Words::tr("not needed").toStdString()});
    }
  }

  std::vector<SignatureRow> Take() && { return std::move(rows_); }

 private:
  std::string WordsOf(const std::string& member) const {
    const auto& all = compatibility_.mismatches;
    const auto it =
        std::ranges::find_if(all, [&](const Mismatch& one) { return one.member == member; });
    return it == all.end() ? std::string() : it->text;
  }

  Compatibility compatibility_;
  std::vector<SignatureRow> rows_;
};

}  // namespace

std::vector<SignatureRow> SignatureDiff(const RequiredDescription& required,
                                        const ProvidedDescription& provided) {
  Diff diff(Compare(required, provided));
  diff.AddNeeded(required.functions, provided.commands, false);
  diff.AddNeeded(required.event_handlers, provided.events, true);
  diff.AddUnneeded(required.functions, provided.commands, false);
  diff.AddUnneeded(required.event_handlers, provided.events, true);
  return std::move(diff).Take();
}

}  // namespace tendon::gui
