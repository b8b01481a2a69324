# The installation, in three components: runtime (the shared library, LICENSE), development, documentation.
set(pages_dir "${CMAKE_INSTALL_DATAROOTDIR}/doc/algsurf")
if(top_level) # otherwise this is where a project around this has its own
    set(pages_dir "${CMAKE_INSTALL_DOCDIR}")
endif()
install(FILES LICENSE DESTINATION "${pages_dir}" COMPONENT runtime)
install(TARGETS ${libraries} EXPORT algsurf-targets
        RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT runtime
        LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT runtime NAMELINK_COMPONENT development
        ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development)
install(FILES ${public_headers} DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/algsurf" COMPONENT development)

# The pages lie as they do here, so that links from one to another lead there.
file(GLOB pages CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" *.md include/algsurf/*.md lib/*.md
     examples/guide/*.md)
foreach(page IN LISTS pages)
    get_filename_component(folder "${page}" DIRECTORY)
    install(FILES "${page}" DESTINATION "${pages_dir}/${folder}" COMPONENT documentation)
endforeach()

set(cmake_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/algsurf")
include(CMakePackageConfigHelpers)
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/algsurf-config-version.cmake"
                                 COMPATIBILITY SameMajorVersion)
configure_file(pkgconfig/algsurf-config.cmake.in "${CMAKE_CURRENT_BINARY_DIR}/algsurf-config.cmake" @ONLY)
install(EXPORT algsurf-targets NAMESPACE algsurf:: DESTINATION "${cmake_package_dir}" COMPONENT development)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/algsurf-config.cmake"
              "${CMAKE_CURRENT_BINARY_DIR}/algsurf-config-version.cmake"
        DESTINATION "${cmake_package_dir}" COMPONENT development)

# The .pc file finds its prefix from where it lies, so that an installed tree can be moved.
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}" OR IS_ABSOLUTE "${CMAKE_INSTALL_INCLUDEDIR}")
    set(pc_prefix "${CMAKE_INSTALL_PREFIX}")
    set(pc_libdir "${CMAKE_INSTALL_FULL_LIBDIR}")
    set(pc_includedir "${CMAKE_INSTALL_FULL_INCLUDEDIR}")
else()
    file(RELATIVE_PATH pc_up "/prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/prefix")
    string(REGEX REPLACE "/$" "" pc_up "${pc_up}")
    set(pc_prefix "\${pcfiledir}/${pc_up}")
    set(pc_libdir "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
    set(pc_includedir "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
endif()
set(pc_private "-lm")
if(threads)
    string(APPEND pc_private " -pthread")
endif()
set(pc_public "")
if(NOT shared) # every program is linked with the archive
    set(pc_public " ${pc_private}")
endif()
configure_file(pkgconfig/algsurf.pc.in "${CMAKE_CURRENT_BINARY_DIR}/algsurf.pc" @ONLY)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/algsurf.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig"
        COMPONENT development)
