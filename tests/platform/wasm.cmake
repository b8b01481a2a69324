# CMake toolchain: WebAssembly with SIMD, by Debian's clang, lld, wasi-libc and libclang-rt-14-dev-wasm32; programs
# run in node, by tests/platform/wasm_run.mjs.
set(CMAKE_SYSTEM_NAME Generic) # CMake 3.25 has no name for WASI
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_C_COMPILER clang)
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
set(CMAKE_AR llvm-ar)
set(CMAKE_RANLIB llvm-ranlib)
set(CMAKE_C_FLAGS_INIT "-msimd128 -D_WASI_EMULATED_GETPID")
# -O3 takes clang 14 twelve times as long, and gains nothing.
set(CMAKE_C_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "flags of a Release build")
# The stack is below the data, so that a call that needs more traps instead of writing over them.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-Wl,-z,stack-size=1048576,--stack-first -lwasi-emulated-getpid")
set(CMAKE_CROSSCOMPILING_EMULATOR node;--no-warnings;${CMAKE_CURRENT_LIST_DIR}/wasm_run.mjs)
