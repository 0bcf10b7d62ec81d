/// Another program: whether it is there, and a run of it that is fed through its standard input.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace amble {

/// A program of this name on the path of programs; empty where there is none.
std::filesystem::path findProgram(const std::string& name);

/// A run of a program, which writes what it makes into a file without a name: whatever ends us,
/// nothing half-written is left. Ctrl-C on the terminal does not reach it.
class ChildProgram {
 public:
  /// Where the program finds that file.
  static constexpr const char* kResult = "/dev/fd/3";

  /// @throws std::system_error where it cannot be started
  ChildProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments);
  /// Ends a run that has not ended.
  ~ChildProgram();
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  /// To its standard input. @return false once it takes no more
  bool feed(std::string_view bytes);
  /// Ends its input and waits. @return its exit status; -1 where it broke
  int finish();
  /// What it made. @pre finished
  void writeResult(std::ostream& out);
  /// The first line of what it complained of; empty where it did not. @pre finished
  std::string complaint();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using File = std::unique_ptr<std::FILE, Close>;
  static File namelessFile();

  File result_, complaints_, input_;
  int process_ = -1;  // -1 once it has ended
};

}  // namespace amble
