/// Numbers that fill megabytes, all 0 at first: in large pages where the system has them (2 MB each
/// in place of 4 kB), which are handed out, cleared, in a tenth of the time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>

namespace amble {

/// All 0. @throws std::bad_alloc
void* takeZeroed(size_t bytes);
/// @param bytes  as many as were taken
void giveBack(void* memory, size_t bytes) noexcept;

/// Of a fixed size, otherwise as a std::vector is.
template <typename T>
class LargeArray {
 public:
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

  LargeArray() = default;
  explicit LargeArray(size_t size)
      : size_(size), data_(static_cast<T*>(takeZeroed(size * sizeof(T)))) {}
  LargeArray(const LargeArray& other) : LargeArray(other.size_) {
    std::copy(other.begin(), other.end(), begin());
  }
  LargeArray(LargeArray&& other) noexcept
      : size_(std::exchange(other.size_, 0)), data_(std::exchange(other.data_, nullptr)) {}
  LargeArray& operator=(LargeArray other) noexcept {
    std::swap(size_, other.size_);
    std::swap(data_, other.data_);
    return *this;
  }
  ~LargeArray() { giveBack(data_, size_ * sizeof(T)); }

  size_t size() const { return size_; }
  T& operator[](size_t i) { return data_[i]; }
  const T& operator[](size_t i) const { return data_[i]; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }

 private:
  size_t size_ = 0;
  T* data_ = nullptr;
};

}  // namespace amble
