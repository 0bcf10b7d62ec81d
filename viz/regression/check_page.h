/// What `amble check` found, as one page: a card for each scenario with its picture and figures,
/// and for what is not as it was accepted both pictures beside one another.
#pragma once

#include <ostream>
#include <vector>

#include "scenarios/check_scenarios.h"

namespace amble {

/// index.html: one file that asks for nothing else, with the pictures in it, that opens without a
/// network. It can be searched, filtered and sorted; without scripts it is all there in the order
/// of the rows. Names are of any bytes. The same rows give the same bytes.
void writeCheckPage(std::ostream& out, const std::vector<CheckRow>& rows);

}  // namespace amble
