# find_package(algsurf) gives algsurf::algsurf (shared) and algsurf::static.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
include("${CMAKE_CURRENT_LIST_DIR}/algsurf-targets.cmake")
