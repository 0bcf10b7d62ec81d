/// Standard streams as the commands may rely on them, whatever the program was started with.
#pragma once

namespace amble {

/// Standard input, output and error that were closed get `/dev/null` in their place, so that no
/// result file is taken for one of them; writing to such an output fails, as it does to a full
/// disk. What cannot be written to standard error is lost, and nothing else with it: messages never
/// throw. To be called once, before anything is written.
void prepareStandardStreams();

}  // namespace amble
