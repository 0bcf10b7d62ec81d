/// Which Amble this is.
#pragma once

#include <string>

namespace amble {

/// "MAJOR.MINOR.PATCH", as reports and `amble --version` say it.
std::string version();

}  // namespace amble
