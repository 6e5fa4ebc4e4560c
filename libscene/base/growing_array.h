// An array that grows to most of the memory that there is.
#pragma once

#include "libscene/base/huge_pages.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

namespace masu {

// As std::vector of what can be copied as bytes, but for growing by realloc(), which moves the pages of large
// arrays instead of copying them: at no time are there two of it, and memory that was reserved and isn't
// written yet is no page's. Allocation throws std::bad_alloc.
template <class T>
class GrowingArray {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignof(std::max_align_t));

public:
  GrowingArray() = default;
  GrowingArray(std::initializer_list<T> values) { append(values); }
  GrowingArray(const GrowingArray& other) { append(other); }
  GrowingArray(GrowingArray&& other) noexcept { swap(other); }
  GrowingArray& operator=(const GrowingArray& other) {
    GrowingArray copy(other);
    swap(copy);
    return *this;
  }
  GrowingArray& operator=(GrowingArray&& other) noexcept {
    GrowingArray moved(std::move(other));
    swap(moved);
    return *this;
  }
  ~GrowingArray() { std::free(data_); }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* data() { return data_; }
  const T* data() const { return data_; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T& back() { return data_[size_ - 1]; }
  const T& back() const { return data_[size_ - 1]; }

  // Exactly so much, if it has less.
  void reserve(std::size_t capacity) {
    if (capacity <= capacity_) return;
    if (capacity > std::numeric_limits<std::size_t>::max() / sizeof(T)) throw std::bad_alloc();
    void* const grown = std::realloc(data_, capacity * sizeof(T));
    if (grown == nullptr) throw std::bad_alloc();
    if (data_ == nullptr) prefer_huge_pages(grown, capacity * sizeof(T)); // what grows would split them
    data_ = static_cast<T*>(grown);
    capacity_ = capacity;
  }
  // `count` more, for the caller to write: each as if by new.
  std::span<T> extend(std::size_t count) {
    if (count > capacity_ - size_) grow(count);
    size_ += count;
    return {data_ + size_ - count, count};
  }
  void push_back(const T& value) {
    const T copy = value; // which may be one of these
    if (size_ == capacity_) grow(1);
    new (data_ + size_++) T(copy);
  }
  // `values` aren't of this array.
  void append(std::span<const T> values) {
    if (values.size() > capacity_ - size_) grow(values.size());
    std::uninitialized_copy(values.begin(), values.end(), data_ + size_);
    size_ += values.size();
  }
  void assign(std::size_t count, const T& value) {
    const T copy = value; // which may be one of these
    reserve(count);
    std::uninitialized_fill_n(data_, count, copy);
    size_ = count;
  }
  void clear() { size_ = 0; }

private:
  void grow(std::size_t by) { reserve(std::max(size_ + by, size_ + size_ / 2 + 8)); }
  void swap(GrowingArray& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  T* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

} // namespace masu
