# How everything of ours is compiled, and one function for each kind of folder.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug or Asan" FORCE)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
set(CMAKE_CXX_FLAGS_DEBUG "-O0 -g")
set(amble_sanitizers "-fsanitize=address,undefined -fno-sanitize-recover=undefined")
set(CMAKE_CXX_FLAGS_ASAN "-O1 -g1 -fno-omit-frame-pointer ${amble_sanitizers}")
set(CMAKE_EXE_LINKER_FLAGS_ASAN "${amble_sanitizers}")

find_program(AMBLE_CCACHE ccache)
if(AMBLE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${AMBLE_CCACHE}")
  if(AMBLE_PCH)  # which ccache takes only so
    set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_SLOPPINESS=pch_defines,time_macros "${AMBLE_CCACHE}")
  endif()
endif()

# With AMBLE_PCH: targets of one group (the same flags) share a precompiled header, made with the first of them.
function(amble_pch group target)
  if(NOT AMBLE_PCH)
    return()
  endif()
  # g++ 12 forgets with them that <string> is a system header, and warns of what is not so (PR 105329, 105651).
  target_compile_options(${target} PRIVATE -fpch-preprocess -Wno-array-bounds -Wno-restrict
                                           -Wno-stringop-overflow -Wno-stringop-overread)
  get_property(first GLOBAL PROPERTY amble_pch_${group})
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
  else()
    target_precompile_headers(${target} PRIVATE ${ARGN})
    set_property(GLOBAL PROPERTY amble_pch_${group} ${target})
  endif()
endfunction()
set(amble_std_headers <Eigen/Geometry> <algorithm> <array> <cmath> <filesystem> <functional> <map>
                      <memory> <optional> <ostream> <span> <string> <vector>)

# With AMBLE_UNITY: the sources of a room are compiled together, some at a time, which instantiates each template of
# Eigen's and the standard library's once for all of them. Names in their unnamed namespaces must then differ.
# More than 10 at most (or the number that is given) are little quicker in all, and slow where one of them is edited.
function(amble_unity target)
  set(together 10)
  if(ARGN)
    set(together ${ARGN})
  endif()
  if(NOT AMBLE_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  list(SORT sources)
  set(rooms "${sources}")
  list(TRANSFORM rooms REPLACE "/[^/]+$" "")
  list(REMOVE_DUPLICATES rooms)
  foreach(room ${rooms})
    set(in_room "${sources}")
    list(FILTER in_room INCLUDE REGEX "^${room}/[^/]+$")
    list(LENGTH in_room count)
    math(EXPR groups "(${count} + ${together} - 1) / ${together}")
    file(RELATIVE_PATH name "${PROJECT_SOURCE_DIR}" "${room}")
    string(MAKE_C_IDENTIFIER "${name}" name)
    set(i 0)
    foreach(source ${in_room})
      math(EXPR group "${i} * ${groups} / ${count}")
      set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${name}_${group}")
      math(EXPR i "${i} + 1")
    endforeach()
  endforeach()
endfunction()

# For what runs once, such as options and their texts: a quarter less to compile. Before amble_pch, which takes it over.
function(amble_runs_once target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# g++ looks for garbage again and again as it compiles, a sixth of its time; where it may fill this first it seldom does, for
# 200 MB more a file at most.
set(amble_collector "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param ggc-min-heapsize=600000>")  # [kB]

# Flags of every target of ours. Fused multiply-add would make results depend on the compiler.
function(amble_flags target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off
                                           $<$<BOOL:${AMBLE_WERROR}>:-Werror> ${amble_collector})
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}")
endfunction()

# The library amble_<folder>, as amble::<folder>, of every .cpp in this folder and its rooms.
#   PUBLIC   headers that its users begin with (docs/cpp.md); they are installed, with what they include, and so is the
#            library, which without such is for the program alone
#   USES     our libraries below
#   PRIVATE  third-party libraries, whose headers stay in the .cpp files
#   WITHOUT  rooms that are no part of it
function(amble_library folder)
  cmake_parse_arguments(arg "" "" "PUBLIC;USES;PRIVATE;WITHOUT" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "*.cpp")
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS "*.h")
  foreach(room ${arg_WITHOUT})
    list(FILTER sources EXCLUDE REGEX "/${folder}/${room}/")
    list(FILTER headers EXCLUDE REGEX "/${folder}/${room}/")
  endforeach()
  set(target amble_${folder})
  add_library(${target} STATIC ${sources} ${headers})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${folder} LINKER_LANGUAGE CXX)
  add_library(amble::${folder} ALIAS ${target})
  amble_flags(${target})
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O3>)  # tests would be longer in compiling
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                              $<INSTALL_INTERFACE:include/amble>)
  amble_pch(libraries ${target} ${amble_std_headers})
  amble_unity(${target})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_link_libraries(${target} PUBLIC Eigen3::Eigen ${arg_USES} PRIVATE ${arg_PRIVATE})
  if(arg_PUBLIC)
    install(TARGETS ${target} EXPORT amble-targets)
  endif()
  foreach(header ${arg_PUBLIC})
    set_property(GLOBAL APPEND PROPERTY amble_public "${folder}/${header}")
  endforeach()
endfunction()

# Into `out`: the libraries' public headers and all that they include, as paths from the root. No other is installed.
function(amble_public_headers out)
  get_property(open GLOBAL PROPERTY amble_public)
  set(found "")
  while(open)
    list(POP_FRONT open header)
    if(header IN_LIST found)
      continue()
    endif()
    list(APPEND found "${header}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${header}")
    file(STRINGS "${PROJECT_SOURCE_DIR}/${header}" includes REGEX "^ *#include \"")
    foreach(include ${includes})
      string(REGEX REPLACE ".*\"([^\"]+)\".*" "\\1" included "${include}")
      list(APPEND open "${included}")
    endforeach()
  endwhile()
  list(SORT found)
  set(${out} "${found}" PARENT_SCOPE)
endfunction()

# The program amble_<folder>_tests of tests/<folder>/ and its rooms. It is linked to that folder's library only, so
# that a test which reaches up does not link.
#   PRIVATE  third-party libraries whose headers the tests include
#   WITHOUT  rooms that have a program of their own
function(amble_tests folder)
  cmake_parse_arguments(arg "" "" "PRIVATE;WITHOUT" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${folder}/*.cpp" "${folder}/*.h")
  foreach(room ${arg_WITHOUT})
    list(FILTER sources EXCLUDE REGEX "/${folder}/${room}/")
  endforeach()
  if(NOT sources MATCHES "_test\\.cpp")
    return()
  endif()
  set(target amble_${folder}_tests)
  add_executable(${target} ${sources})
  amble_flags(${target})
  target_include_directories(${target} PRIVATE "${PROJECT_BINARY_DIR}/generated")
  target_link_libraries(${target} PRIVATE amble_${folder} GTest::gtest_main ${arg_PRIVATE})
  amble_pch(tests ${target} <gtest/gtest.h> ${amble_std_headers})
  amble_unity(${target})
  gtest_discover_tests(${target} TEST_PREFIX "${folder}." DISCOVERY_MODE PRE_TEST
                       PROPERTIES TIMEOUT 600)
endfunction()
