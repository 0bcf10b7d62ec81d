#include "planner/ompl/quiet_ompl.h"

#include <ompl/util/Console.h>

namespace amble {

QuietOmpl::QuietOmpl() : level_(ompl::msg::getLogLevel()) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
}

QuietOmpl::~QuietOmpl() { ompl::msg::setLogLevel(static_cast<ompl::msg::LogLevel>(level_)); }

}  // namespace amble
