# The imported target amble::ompl.
#
# Debian's omplConfig.cmake gives variables only, and OMPL_LIBRARIES names Boost libraries that it does not look for.

find_library(AMBLE_OMPL_LIBRARY ompl)
find_path(AMBLE_OMPL_INCLUDE ompl/base/Planner.h PATH_SUFFIXES ompl-1.5 ompl-1.6 ompl)
mark_as_advanced(AMBLE_OMPL_LIBRARY AMBLE_OMPL_INCLUDE)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(AmbleOmpl REQUIRED_VARS AMBLE_OMPL_LIBRARY AMBLE_OMPL_INCLUDE
                                  REASON_FAILURE_MESSAGE "libompl-dev is missing")
if(AmbleOmpl_FOUND AND NOT TARGET amble::ompl)
  add_library(amble::ompl UNKNOWN IMPORTED)
  set_target_properties(amble::ompl PROPERTIES IMPORTED_LOCATION "${AMBLE_OMPL_LIBRARY}"
                                               INTERFACE_INCLUDE_DIRECTORIES "${AMBLE_OMPL_INCLUDE}")
endif()
