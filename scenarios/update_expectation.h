/// Setting one value in a scenario's text without touching the rest of it: comments and layout are
/// the author's.
#pragma once

#include <string>

namespace amble {

/// The text of a scenario with `expect: bvh_sha256:` set, and nothing else changed. @throws
/// InputError where that cannot be done
std::string withDigest(const std::string& text, const std::string& file, const std::string& digest);

}  // namespace amble
