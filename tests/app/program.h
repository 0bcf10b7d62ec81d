/// Runs the built program in a folder of the test's own, as a shell does.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

namespace amble {

class Program : public testing::Test {
 protected:
  struct Ran {
    int status = -1;
    std::string out, err;
    size_t memory = 0;  ///< largest that it, or a process of its own, had at a time [bytes]
  };

  void SetUp() override;
  void TearDown() override;

  /// `amble ARGUMENTS` in folder_, with standard input empty. The arguments are a shell's: they may
  /// be quoted, and redirect.
  /// @param before  shell commands that run first, such as a limit
  Ran run(const std::string& arguments, const std::string& before = "") const;

  /// The same on a terminal of its own, by script(1): what it shows there, both streams, is `out`.
  Ran onTerminal(const std::string& arguments, const std::string& before = "") const;

  /// A line as a reader of the docs types it, `amble` being the program.
  Ran type(const std::string& line) const;

  /// Writes a file into folder_; its folders are made.
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  /// Every file below folder_.
  std::set<std::string> files() const;

  /// Exit status 2, nothing on standard output, one line on standard error that holds each of
  /// `parts` in this order, and no file that was not there before.
  void expectRefused(const std::string& arguments, const std::vector<std::string>& parts,
                     const std::string& before = "") const;

  /// A shell's commands in folder_, with the program as $AMBLE.
  Ran shell(const std::string& commands, const std::string& before = "") const;

  std::filesystem::path folder_;
};

/// A floor of 6 x 4 m, in/room.yaml, and 4 m to walk over it, in/scenario.yaml.
class InRoom : public Program {
 protected:
  static const std::string kRoom, kScenario;

  void SetUp() override;
  /// A wall between start and goal.
  void wallOff() const;
  /// No walk, and far too many samples to try.
  void makeEndless() const;
};

std::filesystem::path sourceFolder();
/// All that is in that file.
std::string textOf(const std::filesystem::path& file);
/// mocap/ of the shared folder, with a slash behind it.
std::string captureFolder();

}  // namespace amble
