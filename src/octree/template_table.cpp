#include "octree/template_table.hpp"

namespace unsliver::octree {

const Template& TemplateStore::find_or_solve(Key key) {
  const std::lock_guard lock(guard_);
  std::unique_ptr<const Template>& entry = templates_[key.bits()];
  if (!entry) entry = std::make_unique<const Template>(solve_template(key));
  return *entry;
}

const Template& TemplateCache::add(Key key) {
  const Template& value = store_.find_or_solve(key);
  if (2 * ++count_ > entries_.size()) {
    const std::vector<Entry> old = std::exchange(entries_, std::vector<Entry>(2 * entries_.size()));
    for (const Entry& entry : old)
      if (entry.value != nullptr) place(entry);
  }
  place({key.bits(), &value});
  return value;
}

void TemplateCache::place(const Entry& entry) {
  std::size_t i = slot(Key(entry.key));
  while (entries_[i].value != nullptr) i = (i + 1) & (entries_.size() - 1);
  entries_[i] = entry;
}

}  // namespace unsliver::octree
