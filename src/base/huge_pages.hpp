/// \file
/// Hints to the system about the memory of large arrays.
#pragma once

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstddef>
#include <cstdint>

namespace unsliver {

/// The large pages that fit into a block of memory. Random access over hundreds of megabytes misses the page
/// tables' cache as often as the data's, and the first write to small pages costs more than the writing.
///
/// All members are without effect on systems that do not know such hints.
class HugePages {
 public:
  HugePages(void* block, std::size_t bytes) {
    const auto first = reinterpret_cast<std::uintptr_t>(block);
    begin_ = (first + kSize - 1) / kSize * kSize;
    const std::uintptr_t end = (first + bytes) / kSize * kSize;
    count_ = end > begin_ ? (end - begin_) / kSize : 0;
  }

  std::size_t count() const { return count_; }

  /// To be called before the block is first written. Small blocks are left alone.
  void prefer() const {
#ifdef MADV_HUGEPAGE
    constexpr std::size_t kFew = 4;
    if (count_ > kFew) madvise(at(0), count_ * kSize, MADV_HUGEPAGE);
#endif
  }

  /// Has the system provide one of them now: several threads can ask, where a first write is one thread's.
  void populate([[maybe_unused]] std::size_t number) const {
#ifdef MADV_POPULATE_WRITE
    madvise(at(number), kSize, MADV_POPULATE_WRITE);
#endif
  }

 private:
  static constexpr std::uintptr_t kSize = std::uintptr_t{1} << 21;

  void* at(std::size_t number) const { return reinterpret_cast<void*>(begin_ + number * kSize); }

  std::uintptr_t begin_;
  std::size_t count_;
};

}  // namespace unsliver
