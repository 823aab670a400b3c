# What `cmake --install` gives: library, headers, command line, schema, and find_package(burnish) for strangers.
include(CMakePackageConfigHelpers)

# Libraries are found beside the binaries, wherever the tree (or the Python wheel) is put.
file(RELATIVE_PATH burnish_lib_from_bin /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
set_target_properties(burnish PROPERTIES INSTALL_RPATH "$ORIGIN")
set_target_properties(burnish-cli PROPERTIES INSTALL_RPATH "$ORIGIN/${burnish_lib_from_bin};$ORIGIN/..")

install(TARGETS burnish EXPORT burnish-targets LIBRARY COMPONENT core NAMELINK_COMPONENT core FILE_SET HEADERS COMPONENT core)
install(TARGETS burnish-cli RUNTIME COMPONENT core)
install(FILES ${CMAKE_BINARY_DIR}/share/burnish/shot.schema.json burnish/material/presets.json burnish/material/merl_sgd.json
        DESTINATION ${CMAKE_INSTALL_DATADIR}/burnish COMPONENT core)

set(burnish_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/burnish)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/burnish-config.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/burnish-config.cmake
                              INSTALL_DESTINATION ${burnish_package_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/burnish-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/burnish-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/burnish-config-version.cmake
        DESTINATION ${burnish_package_dir} COMPONENT core)
install(EXPORT burnish-targets NAMESPACE burnish:: DESTINATION ${burnish_package_dir} COMPONENT core)
