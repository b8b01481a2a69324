# cmake --build build --target gallery-complex: surfaces in complex space, as build/gallery-complex/NAME.png
#
# The pictures are those of Sanjuan-Estrada, Casado, Garcia, Rendering (complex) algebraic surfaces, figures
# 2 to 11: which surfaces, which coefficient p_k of the ray's polynomial gets an imaginary part, and delta.
# The paper does not print the imaginary parts, nor where the eye stands; those here are ours, chosen so
# that something vanishes or appears.  Arguments are of t measured from the eye: the same delta shows more
# from a farther eye.  Pictures of one surface share one view.
#
#     picture                       imaginary part      delta
#     sphere-p0-10, sphere-p0-70    p_0: 1              pi/18, 7pi/18
#     tangle-p0, tangle-p2          p_0: 2; p_2: 0.3    pi/180; pi/18
#     whitney-p0                    p_0: 1.5            pi/18
#     steiner-0 ... steiner-5       none                1e-10, then 1 to 5 degrees: pi/180 to pi/36
#     boy-p0 ... boy-p4             10 each             pi/18
#     NAME-real                     none                1e-10: real space

set(sphere_view --extent sphere:2 --eye 2.6,-3.2,1.9 --fov 56)
set(tangle_view --fov 33)
set(whitney_view --eye 5.263,-2.382,1.736 --look-at 0,0,0 --fov 46)
set(steiner_view --eye 1.2,-1.7,1.31 --fov 40)
set(boy_view --eye 3.9,-5,1.3 --look-at 0,0,1 --fov 36)

set(complex_folder "${PROJECT_BINARY_DIR}/gallery-complex")
set(complex_pictures "")
macro(complex_picture surface name) # complex_picture(SURFACE NAME OPTION...)
    set(picture "${complex_folder}/${surface}-${name}.png")
    add_custom_command(OUTPUT "${picture}"
        COMMAND ${CMAKE_COMMAND} -E make_directory "${complex_folder}"
        COMMAND render ${surface} ${${surface}_view} ${ARGN} --progress never --output "${picture}"
        DEPENDS render COMMENT "Rendering ${surface}-${name}" VERBATIM)
    list(APPEND complex_pictures "${picture}")
endmacro()

complex_picture(sphere real --delta 1e-10)
complex_picture(sphere p0-10 --imag 0=1 --delta pi/18)
complex_picture(sphere p0-70 --imag 0=1 --delta 7pi/18)
complex_picture(tangle real --delta 1e-10)
complex_picture(tangle p0 --imag 0=2 --delta pi/180)
complex_picture(tangle p2 --imag 2=0.3 --delta pi/18)
complex_picture(whitney real --delta 1e-10)
complex_picture(whitney p0 --imag 0=1.5 --delta pi/18)
complex_picture(steiner 0 --delta 1e-10)
complex_picture(steiner 1 --delta pi/180)
complex_picture(steiner 2 --delta pi/90)
complex_picture(steiner 3 --delta pi/60)
complex_picture(steiner 4 --delta pi/45)
complex_picture(steiner 5 --delta pi/36)
complex_picture(boy real --delta 1e-10)
foreach(k RANGE 4)
    complex_picture(boy p${k} --imag ${k}=10 --delta pi/18)
endforeach()
add_custom_target(gallery-complex DEPENDS ${complex_pictures})
