#include "app/program.h"

int main(int argc, char** argv) { return amble::runProgram(argc, argv); }
