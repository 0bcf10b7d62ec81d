cmake_policy(VERSION 3.25)
# The walls of the house (DESIGN.md, section 1). Every source stands in a room; no room includes one above it; what runs
# inside a plan includes nothing that prepares captures; third-party headers, Eigen aside, are included by .cpp files only
# (those that the program and the module are made with, CLI11 and pybind11, apart); an installed header includes installed
# ones only.
#   -DROOT=  source tree   -DPUBLIC=  installed headers, separated by |

# From the ground floor up. An entry is a folder, without its subfolders, or one file without its ending.
set(rooms
  base
  animation/body animation/ground
  animation/captures animation/clips
  animation/library
  animation/analysis animation/steps
  animation/editing
  animation/graph animation/grafting
  animation/preparation animation/synthesis
  animation/quality
  environments/furniture
  environments/scene environments/ground environments/body environments/collision environments/map
  planner/search_limits planner/plan_request
  planner/steering planner/refinement planner/why planner/refine_walk
  planner/roadmap planner/ompl planner/legs planner/plan_walk
  scenarios
  viz viz/figure viz/pictures viz/exchange viz/page viz/regression
  batch/job batch/labels batch/run
  app
  python)
list(FIND rooms animation/steps steps_floor)
set(runtime animation/library animation/steps animation/synthesis)
set(offline animation/clips animation/analysis animation/editing animation/graph animation/grafting animation/preparation)

# Into `room` and `floor`: the room that `file`, a path from the root, stands in, and its place in the list, or -1.
macro(find_room file)
  string(REGEX REPLACE "\\.[a-z]+$" "" room "${file}")
  list(FIND rooms "${room}" floor)
  if(floor EQUAL -1)
    get_filename_component(room "${file}" DIRECTORY)
    list(FIND rooms "${room}" floor)
  endif()
endmacro()

string(REPLACE "|" ";" public "${PUBLIC}")
foreach(folder base animation environments planner scenarios viz batch app python)
  file(GLOB_RECURSE files RELATIVE "${ROOT}" "${ROOT}/${folder}/*.h" "${ROOT}/${folder}/*.cpp")
  foreach(file ${files})
    find_room("${file}")
    if(floor EQUAL -1)
      message(SEND_ERROR "${file}: stands in no room; expected one of those that tests/layers.cmake lists")
      continue()
    endif()
    set(own_room "${room}")
    set(own_floor "${floor}")
    file(STRINGS "${ROOT}/${file}" includes REGEX "^ *#include")
    foreach(include ${includes})
      if(NOT folder MATCHES "^(app|python)$" AND file MATCHES "\\.h$" AND include MATCHES "<[^>]*/" AND NOT include MATCHES "<Eigen/")
        message(SEND_ERROR "${file}: ${include}; expected third-party headers in .cpp files only")
      endif()
      if(NOT include MATCHES "\"([^\"]+)\"")
        continue()
      endif()
      set(included "${CMAKE_MATCH_1}")
      find_room("${included}")
      if(floor EQUAL -1)
        message(SEND_ERROR "${file}: ${include}; expected a header of a room, by its path from the root")
      elseif(floor GREATER own_floor)
        message(SEND_ERROR "${file}: ${include}; expected nothing above ${own_room}")
      elseif(folder STREQUAL environments AND included MATCHES "^animation/" AND floor GREATER steps_floor)
        message(SEND_ERROR "${file}: ${include}; expected nothing of animation above its steps")
      elseif(own_room IN_LIST runtime AND room IN_LIST offline)
        message(SEND_ERROR "${file}: ${include}; expected nothing of what prepares captures")
      endif()
      if(file IN_LIST public AND NOT included IN_LIST public)
        message(SEND_ERROR "${file}: ${include}; expected an installed header to include installed ones only")
      endif()
    endforeach()
  endforeach()
endforeach()
