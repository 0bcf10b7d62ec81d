#include "app/open_file.h"

#include <spawn.h>
#include <sys/wait.h>

#include <string>

#include "base/error.h"

extern char** environ;

namespace amble {

void openFile(const std::filesystem::path& file) {
#ifdef __APPLE__
  std::string opener = "open";
#else
  std::string opener = "xdg-open";
#endif
  std::string path = std::filesystem::absolute(file).string();
  char* const arguments[] = {opener.data(), path.data(), nullptr};
  pid_t child = 0;
  int status = 0;
  const bool began =
      ::posix_spawnp(&child, opener.c_str(), nullptr, nullptr, arguments, environ) == 0;
  if (!began || ::waitpid(child, &status, 0) != child || status != 0) {
    throw InputError(file.string(), 0, "cannot be shown: " + opener + " does not do it",
                     "a browser that " + opener + " knows of; the page can be opened by hand");
  }
}

}  // namespace amble
