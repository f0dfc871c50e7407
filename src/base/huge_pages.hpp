/// \file
/// Large arrays on large pages: fewer page faults when they are first written, fewer misses of the page
/// tables' cache after.
#pragma once

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstddef>
#include <cstdint>
#include <vector>

namespace unsliver {

/// A hint: the bytes will be written, and all of them. Without effect on small blocks and on other systems.
inline void prefer_huge_pages([[maybe_unused]] void* block, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
  constexpr std::uintptr_t kHugePage = std::uintptr_t{1} << 21;
  const auto first = reinterpret_cast<std::uintptr_t>(block);
  const auto begin = (first + kHugePage - 1) & ~(kHugePage - 1), end = (first + bytes) & ~(kHugePage - 1);
  if (end > begin + 4 * kHugePage) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

/// array.resize(n), on large pages.
template <class T>
void resize_on_huge_pages(std::vector<T>& array, std::size_t n) {
  array.reserve(n);
  prefer_huge_pages(array.data(), n * sizeof(T));
  array.resize(n);
}

}  // namespace unsliver
