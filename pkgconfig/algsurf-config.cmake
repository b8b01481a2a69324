# find_package(algsurf) gives algsurf::static and, where there are shared libraries, algsurf::algsurf.
if(NOT CMAKE_C_COMPILER_TARGET MATCHES "wasi$") # which has no threads
    include(CMakeFindDependencyMacro)
    find_dependency(Threads)
endif()
include("${CMAKE_CURRENT_LIST_DIR}/algsurf-targets.cmake")
