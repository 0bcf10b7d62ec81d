cmake_policy(VERSION 3.25)
# Installs into a folder of its own, then configures, builds and runs the consumer project against it.
#   -DROOT=  source tree   -DBUILD=  build tree   -DCONSUMER=  this folder   -DWORK=  folder to work in   -DTYPE=  build type

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${WORK}")
run(${CMAKE_COMMAND} --install "${BUILD}" --prefix "${WORK}/prefix")
# Each header that is installed, included by somebody else and alone; docs/cpp.md has them all, and no other.
file(GLOB_RECURSE headers RELATIVE "${WORK}/prefix/include/amble" "${WORK}/prefix/include/amble/*.h")
file(READ "${ROOT}/docs/cpp.md" page)
string(REGEX MATCHALL "[a-z_/]+\\.h" named "${page}")
foreach(header ${headers})
  string(MAKE_C_IDENTIFIER "${header}" name)
  file(WRITE "${WORK}/headers/${name}.cpp" "#include \"${header}\"\n")
  if(NOT header IN_LIST named)
    message(SEND_ERROR "docs/cpp.md: ${header} is missing; expected every header that is installed")
  endif()
endforeach()
foreach(header ${named})
  if(NOT header IN_LIST headers)
    message(SEND_ERROR "docs/cpp.md: ${header} is not installed; expected what is")
  endif()
endforeach()
run(${CMAKE_COMMAND} -S "${CONSUMER}" "-DHEADERS=${WORK}/headers" -B "${WORK}/build" -G Ninja -DCMAKE_BUILD_TYPE=${TYPE}
    "-DCMAKE_PREFIX_PATH=${WORK}/prefix" "-DCMAKE_CXX_FLAGS=${FLAGS}")
run(${CMAKE_COMMAND} --build "${WORK}/build")
# Its data is the installed one: the source tree is not asked for.
run(${CMAKE_COMMAND} -E chdir "${WORK}"
    ${CMAKE_COMMAND} -E env "AMBLE_DATA=${WORK}/prefix/share/amble" "${WORK}/build/consumer")
run("${WORK}/prefix/bin/amble" --version)
run("${WORK}/prefix/bin/amble" inspect
    "${WORK}/prefix/share/amble/animation/motions/default.yaml")
# Where man and the shells look.
foreach(page man/man1/amble.1 bash-completion/completions/amble zsh/site-functions/_amble fish/vendor_completions.d/amble.fish)
  file(SIZE "${WORK}/prefix/share/${page}" size)
  if(size LESS 1000)
    message(SEND_ERROR "${page}: ${size} bytes; expected what `amble help --man` and `amble completion` print")
  endif()
endforeach()
file(REMOVE_RECURSE "${WORK}")
