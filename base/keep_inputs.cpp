#include "base/keep_inputs.h"

#include <system_error>

#include "base/error.h"

namespace amble {

namespace fs = std::filesystem;

void keepInputs(const fs::path& output, const std::vector<fs::path>& inputs) {
  std::error_code not_there;
  if (output == "-" || !fs::is_regular_file(output, not_there)) return;
  for (const fs::path& input : inputs) {
    const fs::path read = input == "-" ? "/dev/stdin" : input;
    if (!fs::equivalent(output, read, not_there)) continue;
    throw InputError(output.string(), 0, "is read too, as " + input.string(),
                     "an output that is no input");
  }
}

}  // namespace amble
