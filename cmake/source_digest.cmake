# Writes a source file that says which program this is: the SHA-256 of its sources, by their paths from the root. Where it
# says so already, it is left as it is.
#   -DROOT=  source tree   -DLIST=  file with a path in it a line   -DOUT=  the file
cmake_policy(VERSION 3.25)
file(STRINGS "${LIST}" sources)
list(SORT sources)
set(lines "")
foreach(source ${sources})
  file(SHA256 "${ROOT}/${source}" digest)
  string(APPEND lines "${source} ${digest}\n")
endforeach()
string(SHA256 digest "${lines}")
file(CONFIGURE OUTPUT "${OUT}" @ONLY CONTENT [[
#include "batch/job/source_digest.h"

namespace amble {

std::string sourceDigest() { return "@digest@"; }

}  // namespace amble
]])
