# `cmake --install`: libraries, headers, program, data (laid out as in the source), and what find_package(amble) reads.
include(CMakePackageConfigHelpers)

install(TARGETS amble EXPORT amble-targets)
install(TARGETS amble_app RUNTIME)

set(pages "${PROJECT_BINARY_DIR}/app/pages")
install(FILES "${pages}/amble.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
install(FILES "${pages}/amble" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions")
install(FILES "${pages}/_amble" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/site-functions")
install(FILES "${pages}/amble.fish" DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d")

amble_public_headers(amble_headers)
foreach(header ${amble_headers})
  get_filename_component(room "${header}" DIRECTORY)
  install(FILES "${header}" DESTINATION "include/amble/${room}")
endforeach()

set(amble_data "${CMAKE_INSTALL_DATADIR}/amble")
install(DIRECTORY animation/motions DESTINATION "${amble_data}/animation" OPTIONAL)
install(DIRECTORY environments/scenes DESTINATION "${amble_data}/environments" OPTIONAL)
install(DIRECTORY scenarios/ DESTINATION "${amble_data}/scenarios" FILES_MATCHING PATTERN "*.yaml")
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}")

set(config_dir "${CMAKE_INSTALL_LIBDIR}/cmake/amble")
install(EXPORT amble-targets NAMESPACE amble:: DESTINATION "${config_dir}")
configure_package_config_file(cmake/amble-config.cmake.in amble-config.cmake
                              INSTALL_DESTINATION "${config_dir}")
write_basic_package_version_file(amble-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/amble-config.cmake"
              "${CMAKE_CURRENT_BINARY_DIR}/amble-config-version.cmake"
              cmake/FindAmbleOmpl.cmake cmake/FindAmbleNettle.cmake
              cmake/FindAmbleYaml.cmake DESTINATION "${config_dir}")
