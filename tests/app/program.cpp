#include "tests/app/program.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "test_paths.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

// As std::system does; and what memory it took [bytes].
int runShell(const std::string& command, size_t& memory) {
  const pid_t shell = ::fork();
  if (shell == 0) {
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(127);
  }
  int status = 0;
  rusage used{};
  EXPECT_EQ(::wait4(shell, &status, 0, &used), shell);
  memory = static_cast<size_t>(used.ru_maxrss) << 10;
  return status;
}

}  // namespace

void Program::SetUp() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = test->name();
  std::replace(name.begin(), name.end(), '/', '_');  // of tests with a parameter
  folder_ = fs::path(testing::TempDir()) / ("amble_app_" + name + "_" + std::to_string(::getpid()));
  fs::remove_all(folder_);
  fs::create_directories(folder_ / "in");
}

void Program::TearDown() {
  fs::remove_all(folder_);
  fs::remove_all(folder_.string() + ".out");
  fs::remove_all(folder_.string() + ".err");
}

Program::Ran Program::run(const std::string& arguments, const std::string& before) const {
  return shell("'" AMBLE_PROGRAM "' " + arguments, before);
}

Program::Ran Program::onTerminal(const std::string& arguments, const std::string& before) const {
  return shell("script -qec \"'" AMBLE_PROGRAM "' " + arguments + "\" /dev/null",
               "export TERM=xterm; " + before);
}

Program::Ran Program::type(const std::string& line) const {
  return shell("amble() { '" AMBLE_PROGRAM "' \"$@\"; }; " + line, "");
}

Program::Ran Program::shell(const std::string& commands, const std::string& before) const {
  // What the shell does first, the redirection of the program itself last, so that a test may
  // redirect too.
  const std::string command =
      "cd '" + folder_.string() + "' && export AMBLE='" AMBLE_PROGRAM "'; " + before + " exec >'" +
      folder_.string() + ".out' 2>'" + folder_.string() + ".err' </dev/null; " + commands;
  Ran ran;
  const int status = runShell(command, ran.memory);
  ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  ran.out = textOf(folder_.string() + ".out");
  ran.err = textOf(folder_.string() + ".err");
  return ran;
}

void Program::write(const std::string& name, const std::string& text) const {
  fs::create_directories((folder_ / name).parent_path());
  std::ofstream(folder_ / name, std::ios::binary) << text;
}

std::string Program::read(const std::string& name) const { return textOf(folder_ / name); }

std::set<std::string> Program::files() const {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
    if (!entry.is_directory()) names.insert(fs::relative(entry.path(), folder_).string());
  }
  return names;
}

void Program::expectRefused(const std::string& arguments, const std::vector<std::string>& parts,
                            const std::string& before) const {
  SCOPED_TRACE("amble " + arguments);
  const std::set<std::string> files_before = files();
  const Ran ran = run(arguments, before);
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  size_t from = 0;
  for (const std::string& part : parts) {
    const size_t found = ran.err.find(part, from);
    EXPECT_NE(found, std::string::npos) << "'" << part << "' is not in: " << ran.err;
    if (found != std::string::npos) from = found + part.size();
  }
  EXPECT_EQ(files(), files_before);
}

const std::string InRoom::kRoom =
    "name: room\n"
    "objects:\n"
    "  - {name: floor, box: {size: [6, 4, 0.1]}, at: [3, 2, -0.05]}\n";
const std::string InRoom::kScenario =
    "scene: room.yaml\n"
    "start: {at: [1, 2], heading: 0}\n"
    "goal: {at: [5, 2], heading: 0}\n";

void InRoom::SetUp() {
  Program::SetUp();
  write("in/room.yaml", kRoom);
  write("in/scenario.yaml", kScenario);
}

void InRoom::wallOff() const {
  write("in/room.yaml",
        read("in/room.yaml") + "  - {name: wall, box: {size: [0.2, 4, 2.5]}, at: [4, 2, 1.25]}\n");
}

void InRoom::makeEndless() const {
  write("in/room.yaml",
        read("in/room.yaml") +
            "  - {name: south, box: {size: [0.2, 1.8, 2.5]}, at: [4, 0.9, 1.25]}\n"
            "  - {name: north, box: {size: [0.2, 1.8, 2.5]}, at: [4, 3.1, 1.25]}\n");
  write("in/scenario.yaml", kScenario + "planner: {max_failures: 1000000, time_limit: 600}\n");
}

fs::path sourceFolder() { return AMBLE_SOURCE_DIR; }

std::string textOf(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

std::string captureFolder() { return std::string(AMBLE_SHARED) + "/mocap/"; }

}  // namespace amble
