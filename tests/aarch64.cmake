# CMake toolchain: 64-bit ARM, with Debian's cross compiler; the tests run under qemu-user.
# AARCH64_PREFIX is a folder with the target's cmocka, gmp and zlib, as tests/check_aarch64 unpacks them.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES AARCH64_PREFIX)

# Headers that come with the system are not ours to warn about.
set(prefix_include "${AARCH64_PREFIX}/usr/include")
set(CMAKE_C_FLAGS_INIT "-isystem ${prefix_include} -isystem ${prefix_include}/aarch64-linux-gnu")

set(CMAKE_FIND_ROOT_PATH "${AARCH64_PREFIX}" /usr/aarch64-linux-gnu)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)

set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64;-L;/usr/aarch64-linux-gnu)
