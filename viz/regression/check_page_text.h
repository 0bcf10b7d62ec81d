/// The parts of the check's page that are the same for all rows.
#pragma once

namespace amble {

extern const char* const kCheckPageStyle;   ///< CSS
extern const char* const kCheckPageScript;  ///< JavaScript: search, filters, order, enlarging

}  // namespace amble
