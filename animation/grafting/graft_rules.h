/// Which upper body goes on which lower one: the composition rules of Shanbhag's thesis (§5.4.2),
/// which permit 9 of the 16 pairs of stand, walk, run and jump.
///
///     1  stand  on  stand, walk, run, jump      3  run   on  walk, run
///     2  walk   on  walk, run                   4  jump  on  jump
#pragma once

#include <string>

#include "animation/analysis/classify_clip.h"

namespace amble {

/// Why an upper body of one type may not be grafted on a base of another, with the rule, in one
/// line; "" where it may. Clips of no single type are refused by §5.1.5.
std::string graftRefusal(MotionType upper, MotionType base);

}  // namespace amble
