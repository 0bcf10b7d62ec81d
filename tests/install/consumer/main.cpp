// A project of somebody else: reads the library that comes with Amble and says what walks are in
// it.
#include <cstdio>

#include "animation/library/motion_library_reader.h"

int main() {
  const amble::MotionLibrary library = amble::openMotionLibrary("default");
  for (const amble::Motion& motion : library.motions) std::printf("%s\n", motion.name.c_str());
  return library.motions.empty() ? 1 : 0;
}
