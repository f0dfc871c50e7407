/// \file
/// A growable array of plain data whose growth moves pages, not bytes.
///
/// std::vector copies into a second block when it grows, so a large mesh would need 2.5 times its size at the
/// peak. realloc remaps large blocks in place, and pages that were never written cost nothing. Elements begin
/// at a cache line, so that records of 32 bytes never straddle two.
#pragma once

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

namespace unsliver {

template <class T>
class PodVector {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  PodVector() = default;
  PodVector(PodVector&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)),
        size_(std::exchange(other.size_, 0)),
        capacity_(std::exchange(other.capacity_, 0)),
        offset_(std::exchange(other.offset_, 0)) {}
  PodVector& operator=(PodVector&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
    std::swap(offset_, other.offset_);
    return *this;
  }
  PodVector(const PodVector&) = delete;
  PodVector& operator=(const PodVector&) = delete;
  ~PodVector() { std::free(block()); }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  /// Bytes of the elements held. Reserved but untouched pages are not counted: the system does not back them.
  std::size_t bytes() const { return size_ * sizeof(T); }

  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T& back() { return data_[size_ - 1]; }
  const T& back() const { return data_[size_ - 1]; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  std::span<const T> span() const { return {data_, size_}; }

  void push_back(const T& value) {
    if (size_ == capacity_) {
      const T copy = value;  // `value` may live in the block that is about to move
      grow_to(size_ + 1);
      data_[size_++] = copy;
    } else {
      data_[size_++] = value;
    }
  }
  /// push_back where `condition` holds, without a branch that nobody could predict.
  void push_back_if(bool condition, const T& value) {
    if (size_ == capacity_) grow_to(size_ + 1);
    data_[size_] = value;
    size_ += condition;
  }
  void pop_back() { --size_; }
  void clear() { size_ = 0; }

  /// New elements are left uninitialised.
  void resize_uninitialized(std::size_t n) {
    if (n > capacity_) grow_to(n);
    size_ = n;
  }
  void resize(std::size_t n, const T& value) {
    const std::size_t old = size_;
    resize_uninitialized(n);
    for (std::size_t i = old; i < n; ++i) data_[i] = value;
  }
  void reserve(std::size_t n) {
    if (n > capacity_) reallocate(n);
  }

 private:
  void grow_to(std::size_t n) {
    const std::size_t wanted = capacity_ + capacity_ / 2 + 16;
    reallocate(n > wanted ? n : wanted);
  }
  /// What realloc gave; the elements begin offset_ bytes behind it.
  void* block() const { return data_ == nullptr ? nullptr : reinterpret_cast<std::byte*>(data_) - offset_; }

  void reallocate(std::size_t n) {
    auto* const moved = static_cast<std::byte*>(std::realloc(block(), n * sizeof(T) + kCacheLine));
    if (moved == nullptr) throw std::bad_alloc();
    const std::size_t offset = -reinterpret_cast<std::uintptr_t>(moved) % kCacheLine;
    if (size_ > 0 && offset != offset_) std::memmove(moved + offset, moved + offset_, size_ * sizeof(T));
    offset_ = offset;
    data_ = reinterpret_cast<T*>(moved + offset);
    capacity_ = n;
    use_huge_pages();
  }

  /// Random access over hundreds of megabytes misses the page tables' cache as often as the data's.
  void use_huge_pages() {
#ifdef __linux__
    constexpr std::uintptr_t kHugePage = std::uintptr_t{1} << 21;
    const auto begin = (reinterpret_cast<std::uintptr_t>(data_) + kHugePage - 1) & ~(kHugePage - 1);
    const auto end = reinterpret_cast<std::uintptr_t>(data_ + capacity_) & ~(kHugePage - 1);
    if (end > begin + 4 * kHugePage) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
  }

  static constexpr std::size_t kCacheLine = 64;

  T* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0, offset_ = 0;
};

}  // namespace unsliver
