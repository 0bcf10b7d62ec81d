/// A thing that a capture's file may leave open: its unit, its vertical axis, its frame time.
#pragma once

#include <string>

namespace amble {

template <typename T>
struct Reading {
  T value{};
  bool guessed = false;  ///< neither the caller nor the file said it
  bool sure = true;      ///< nothing speaks against it
  std::string text;      ///< for people: the value and where it is from
};

}  // namespace amble
