/// What every page has in common: its frame, its style and its program, as the build has bundled
/// them (cmake/AmblePage.cmake).
#pragma once

#include <string_view>

namespace amble {

/// HTML with {{marks}} where the others, and what is shown, go.
std::string_view pageFrame();
std::string_view pageStyle();   ///< CSS
std::string_view pageScript();  ///< JavaScript, three.js and its licence in it

}  // namespace amble
