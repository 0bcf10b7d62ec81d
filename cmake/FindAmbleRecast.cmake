# The imported target amble::recast: Recast and Detour, of which Debian packages no configuration for CMake.

find_library(AMBLE_RECAST_LIBRARY Recast)
find_library(AMBLE_DETOUR_LIBRARY Detour)
find_path(AMBLE_RECAST_INCLUDE Recast.h PATH_SUFFIXES recastnavigation)
mark_as_advanced(AMBLE_RECAST_LIBRARY AMBLE_DETOUR_LIBRARY AMBLE_RECAST_INCLUDE)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(AmbleRecast REQUIRED_VARS AMBLE_RECAST_LIBRARY AMBLE_DETOUR_LIBRARY AMBLE_RECAST_INCLUDE)
if(AmbleRecast_FOUND AND NOT TARGET amble::recast)
  add_library(amble::recast INTERFACE IMPORTED)
  target_link_libraries(amble::recast INTERFACE "${AMBLE_RECAST_LIBRARY}" "${AMBLE_DETOUR_LIBRARY}")
  target_include_directories(amble::recast SYSTEM INTERFACE "${AMBLE_RECAST_INCLUDE}")
endif()
