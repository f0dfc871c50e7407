/// \file
/// Memory that several threads ask the system for.
#pragma once

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstddef>
#include <cstdint>

namespace unsliver {

/// A large block that was never written, in pieces. Its first write costs more for the pages, which the
/// system provides one by one, than for the writing; where one thread has to do that write
/// (std::vector::resize), others can help with the pages.
class PagePieces {
 public:
  PagePieces(void* block, std::size_t bytes) {
    const auto first = reinterpret_cast<std::uintptr_t>(block);
    begin_ = (first + kSize - 1) / kSize * kSize;
    const std::uintptr_t end = (first + bytes) / kSize * kSize;
    count_ = end > begin_ ? (end - begin_) / kSize : 0;
  }

  /// Of whole pieces: what is left at both ends is not worth it.
  std::size_t count() const { return count_; }

  /// Has the system provide a piece's pages now. Without effect on systems that cannot.
  void populate([[maybe_unused]] std::size_t number) const {
#ifdef MADV_POPULATE_WRITE
    madvise(reinterpret_cast<void*>(begin_ + number * kSize), kSize, MADV_POPULATE_WRITE);
#endif
  }

 private:
  static constexpr std::uintptr_t kSize = std::uintptr_t{1} << 21;  ///< a multiple of all page sizes

  std::uintptr_t begin_;
  std::size_t count_;
};

}  // namespace unsliver
