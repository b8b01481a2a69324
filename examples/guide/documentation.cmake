# The reference and the manual pages.
#
#     cmake --build build --target reference    build/reference/index.html, by Doxygen, if there is one
#     cmake --build build --target man          build/man/*.1, from what the programs say to --help
#
# The manual pages stay in the build folder, like the programs they are about.

set(guide_folder "${CMAKE_CURRENT_LIST_DIR}")
set(reference_folder "${PROJECT_BINARY_DIR}/reference")
set(reference_sources "${PROJECT_SOURCE_DIR}")
configure_file("${guide_folder}/Doxyfile.in" "${PROJECT_BINARY_DIR}/Doxyfile" @ONLY)
find_package(Doxygen QUIET)
if(DOXYGEN_FOUND)
    add_custom_target(reference
        COMMAND ${CMAKE_COMMAND} -E make_directory "${reference_folder}"
        COMMAND Doxygen::doxygen "${PROJECT_BINARY_DIR}/Doxyfile"
        COMMENT "${reference_folder}/index.html" VERBATIM)
endif()

set(man_programs render mesh intersect roots zerofind)
list(JOIN man_programs " " man_programs_text)
set(man_pages "")
function(algsurf_man_page program summary)
    set(page "${PROJECT_BINARY_DIR}/man/${program}.1")
    add_custom_command(OUTPUT "${page}"
        COMMAND ${CMAKE_COMMAND} -E make_directory "${PROJECT_BINARY_DIR}/man"
        COMMAND "${guide_folder}/manual" "${page}" "${summary}" "${PROJECT_VERSION}"
                "${man_programs_text}" ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:${program}>
        DEPENDS ${program} "${guide_folder}/manual" COMMENT "${page}" VERBATIM)
    set(man_pages ${man_pages} "${page}" PARENT_SCOPE)
endfunction()

algsurf_man_page(render "draw an algebraic surface")
algsurf_man_page(mesh "make triangles of an algebraic surface")
algsurf_man_page(intersect "find where rays meet an algebraic surface")
algsurf_man_page(roots "find all roots of polynomials, with proofs")
algsurf_man_page(zerofind "plot the polynomial along a ray and how its first root is found")
add_custom_target(man DEPENDS ${man_pages})
