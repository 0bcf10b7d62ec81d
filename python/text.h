/// Texts of the library as Python's: its bytes come from files, and need be no UTF-8.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <string_view>
#include <vector>

namespace amble {

/// What is no UTF-8 in it becomes U+FFFD.
inline pybind11::str toText(std::string_view bytes) {
  PyObject* const text =
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "replace");
  if (text == nullptr) throw pybind11::error_already_set();
  return pybind11::reinterpret_steal<pybind11::str>(text);
}

inline pybind11::tuple toTexts(const std::vector<std::string>& texts) {
  pybind11::tuple tuple(texts.size());
  for (size_t i = 0; i < texts.size(); ++i) tuple[i] = toText(texts[i]);
  return tuple;
}

}  // namespace amble
