/// Values as bytes, from one process of this program to another: as they lie in memory, and no
/// further than that.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace amble {

/// Puts values behind one another as they lie in memory.
class Packer {
 public:
  template <typename T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void operator()(const T& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <int rows, int columns>
  void operator()(const Eigen::Matrix<double, rows, columns>& matrix) {
    bytes_.append(reinterpret_cast<const char*>(matrix.data()), sizeof(double) * rows * columns);
  }
  template <size_t count>
  void operator()(const std::array<int, count>& values) {
    bytes_.append(reinterpret_cast<const char*>(values.data()), sizeof values);
  }
  void operator()(const Eigen::Quaterniond& q) { (*this)(q.coeffs()); }
  void operator()(const std::string& text) {
    (*this)(text.size());
    bytes_ += text;
  }
  template <typename T>
  void operator()(const std::vector<T>& values) {
    (*this)(values.size());
    for (const T& value : values) (*this)(value);
  }
  std::string bytes() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Takes them off again, in the same order. @throws std::runtime_error where the bytes end.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : left_(bytes) {}

  template <typename T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void operator()(T& value) {
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
  }
  template <int rows, int columns>
  void operator()(Eigen::Matrix<double, rows, columns>& matrix) {
    constexpr size_t kBytes = sizeof(double) * rows * columns;
    std::memcpy(matrix.data(), take(kBytes).data(), kBytes);
  }
  template <size_t count>
  void operator()(std::array<int, count>& values) {
    std::memcpy(values.data(), take(sizeof values).data(), sizeof values);
  }
  void operator()(Eigen::Quaterniond& q) { (*this)(q.coeffs()); }
  void operator()(std::string& text) { text = take(takeCount()); }
  template <typename T>
  void operator()(std::vector<T>& values) {
    values.resize(takeCount());
    for (T& value : values) (*this)(value);
  }
  size_t takeCount() {
    size_t count = 0;
    (*this)(count);
    // Nothing that is counted is shorter than a byte.
    if (count > left_.size()) throw std::runtime_error("bytes end too soon");
    return count;
  }

 private:
  std::string_view take(size_t count) {
    if (count > left_.size()) throw std::runtime_error("bytes end too soon");
    const std::string_view taken = left_.substr(0, count);
    left_.remove_prefix(count);
    return taken;
  }

  std::string_view left_;
};

}  // namespace amble
