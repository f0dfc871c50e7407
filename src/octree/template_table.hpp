/// \file
/// Templates by key: each is solved once.
#pragma once

#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "octree/template.hpp"

namespace unsliver::octree {

/// All templates of a run; safe to use from several threads. References stay valid.
class TemplateStore {
 public:
  const Template& find_or_solve(Key key);
  std::size_t size() const { return templates_.size(); }

 private:
  std::mutex guard_;
  std::unordered_map<std::uint64_t, std::unique_ptr<const Template>> templates_;
};

/// One thread's view of the store: a table with open addressing, at most half full.
class TemplateCache {
 public:
  explicit TemplateCache(TemplateStore& store) : store_(store), entries_(kInitialSize) {}

  const Template& operator[](Key key) {
    for (std::size_t i = slot(key);; i = (i + 1) & (entries_.size() - 1)) {
      if (entries_[i].key == key.bits()) [[likely]]
        return *entries_[i].value;
      if (entries_[i].value == nullptr) return add(key);
    }
  }

 private:
  static constexpr std::size_t kInitialSize = 1024;
  struct Entry {
    std::uint64_t key = ~std::uint64_t{0};
    const Template* value = nullptr;
  };

  std::size_t slot(Key key) const { return key.bits() * 0x9E3779B97F4A7C15u >> 32 & (entries_.size() - 1); }
  const Template& add(Key key);
  void place(const Entry& entry);

  TemplateStore& store_;
  std::vector<Entry> entries_;
  std::size_t count_ = 0;
};

}  // namespace unsliver::octree
