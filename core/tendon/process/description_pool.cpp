#include <tendon/process/description_pool.h>

#include <functional>
#include <string>
#include <vector>

namespace tendon {
namespace {

class Hash {
 public:
  void Add(std::size_t value) {
    constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;
    value_ = (value_ ^ value) * kGolden;
    value_ ^= value_ >> 32U;
  }
  void Add(const std::string& text) { Add(std::hash<std::string>()(text)); }
  void Add(const Fingerprint& fingerprint) { Add(fingerprint.low); }
  void Add(const MemberDescription& member) {
    Add(member.name);
    Add(member.signature.in);
    Add(member.signature.out);
  }
  void Add(const ColumnDescription& column) {
    Add(column.name);
    Add(column.fingerprint);
  }
  void Add(const ProvidedDescription& provided) {
    Add(provided.name);
    Add(provided.commands);
    Add(provided.events);
  }
  void Add(const RequiredDescription& required) {
    Add(required.name);
    Add(required.functions);
    Add(required.event_handlers);
  }
  void Add(const TableDescription& table) {
    Add(table.name);
    Add(table.columns);
  }
  template <typename T>
  void Add(const std::vector<T>& list) {
    Add(list.size());
    for (const T& one : list) Add(one);
  }

  [[nodiscard]] std::size_t value() const { return value_; }

 private:
  std::size_t value_ = 0;
};

}  // namespace

template <typename T>
void DescriptionPool::Lists<T>::Share(SharedList<T>& list) {
  if (list.empty()) return;
  if (by_hash.size() >= drop_at) {
    std::erase_if(by_hash, [](const auto& entry) { return entry.second.holders() == 1; });
    drop_at = 64 + 2 * by_hash.size();
  }
  Hash hash;
  hash.Add(list.items());
  SharedList<T>& known = by_hash[hash.value()];
  if (known == list) {
    list = known;
  } else {
    list.Share();
    known = list;
  }
}

void DescriptionPool::Share(ComponentDescription& component) {
  provided_.Share(component.provided);
  required_.Share(component.required);
  tables_.Share(component.tables);
}

std::size_t DescriptionPool::size() const {
  return provided_.by_hash.size() + required_.by_hash.size() + tables_.by_hash.size();
}

}  // namespace tendon
