# The imported target amble::nettle: nettle, which has no configuration for CMake.

find_library(AMBLE_NETTLE_LIBRARY nettle)
find_path(AMBLE_NETTLE_INCLUDE nettle/sha2.h)
mark_as_advanced(AMBLE_NETTLE_LIBRARY AMBLE_NETTLE_INCLUDE)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(AmbleNettle REQUIRED_VARS AMBLE_NETTLE_LIBRARY AMBLE_NETTLE_INCLUDE
                                  REASON_FAILURE_MESSAGE "nettle-dev is missing")
if(AmbleNettle_FOUND AND NOT TARGET amble::nettle)
  add_library(amble::nettle UNKNOWN IMPORTED)
  set_target_properties(amble::nettle PROPERTIES IMPORTED_LOCATION "${AMBLE_NETTLE_LIBRARY}"
                                             INTERFACE_INCLUDE_DIRECTORIES "${AMBLE_NETTLE_INCLUDE}")
endif()
