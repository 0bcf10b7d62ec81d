/// The style of report.html.
#pragma once

namespace amble {

extern const char* const kReportPageStyle;  ///< CSS

}  // namespace amble
