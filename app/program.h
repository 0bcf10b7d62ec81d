/// The program `amble`.
#pragma once

namespace amble {

/// @return its exit status (exit_status.h)
int runProgram(int argc, char** argv);

}  // namespace amble
