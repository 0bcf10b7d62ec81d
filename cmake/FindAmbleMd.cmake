# The imported target amble::md: libmd, which has no configuration for CMake.

find_library(AMBLE_MD_LIBRARY md)
find_path(AMBLE_MD_INCLUDE sha2.h)
mark_as_advanced(AMBLE_MD_LIBRARY AMBLE_MD_INCLUDE)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(AmbleMd REQUIRED_VARS AMBLE_MD_LIBRARY AMBLE_MD_INCLUDE
                                  REASON_FAILURE_MESSAGE "libmd-dev is missing")
if(AmbleMd_FOUND AND NOT TARGET amble::md)
  add_library(amble::md UNKNOWN IMPORTED)
  set_target_properties(amble::md PROPERTIES IMPORTED_LOCATION "${AMBLE_MD_LIBRARY}"
                                             INTERFACE_INCLUDE_DIRECTORIES "${AMBLE_MD_INCLUDE}")
endif()
