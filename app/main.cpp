#include "app/program.h"
#include "base/freed_memory.h"

namespace {

// Most commands fill as much: a scene and what is made of it [bytes].
constexpr size_t kFirstMemory = size_t{30} << 20;

}  // namespace

int main(int argc, char** argv) {
  amble::keepFreedMemory(kFirstMemory);
  return amble::runProgram(argc, argv);
}
