# Installs into a folder of its own, then configures, builds and runs the consumer project against it.
#   -DBUILD=  build tree   -DCONSUMER=  this folder   -DWORK=  folder to work in   -DTYPE=  build type

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${WORK}")
run(${CMAKE_COMMAND} --install "${BUILD}" --prefix "${WORK}/prefix")
# Every header that is installed, included by somebody else.
file(GLOB_RECURSE headers RELATIVE "${WORK}/prefix/include/amble" "${WORK}/prefix/include/amble/*.h")
list(TRANSFORM headers REPLACE "(.+)" "#include \"\\1\"\n" OUTPUT_VARIABLE includes)
string(REPLACE ";" "" includes "${includes}")
file(WRITE "${WORK}/all_headers.cpp" "${includes}")
run(${CMAKE_COMMAND} -S "${CONSUMER}" "-DALL_HEADERS=${WORK}/all_headers.cpp" -B "${WORK}/build" -G Ninja -DCMAKE_BUILD_TYPE=${TYPE}
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
