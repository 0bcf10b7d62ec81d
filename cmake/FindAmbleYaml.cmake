# The imported target amble::yaml: libyaml, which has no configuration for CMake.

find_library(AMBLE_YAML_LIBRARY yaml)
find_path(AMBLE_YAML_INCLUDE yaml.h)
mark_as_advanced(AMBLE_YAML_LIBRARY AMBLE_YAML_INCLUDE)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(AmbleYaml REQUIRED_VARS AMBLE_YAML_LIBRARY AMBLE_YAML_INCLUDE
                                  REASON_FAILURE_MESSAGE "libyaml-dev is missing")
if(AmbleYaml_FOUND AND NOT TARGET amble::yaml)
  add_library(amble::yaml UNKNOWN IMPORTED)
  set_target_properties(amble::yaml PROPERTIES IMPORTED_LOCATION "${AMBLE_YAML_LIBRARY}"
                                               INTERFACE_INCLUDE_DIRECTORIES "${AMBLE_YAML_INCLUDE}")
endif()
