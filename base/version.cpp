#include "base/version.h"

namespace amble {

std::string version() { return AMBLE_VERSION; }

}  // namespace amble
