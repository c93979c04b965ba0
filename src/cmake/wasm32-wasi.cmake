# SPDX-License-Identifier: MIT
# Toolchain for WebAssembly: `zig cc` of the Python package ziglang, which is clang with the headers
# of wasi-libc and the sources of libc++. apps/play/build_wasm.sh names the compilers.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

# Exceptions in the encoding that every browser of today runs; LLVM calls it legacy. zig would turn
# the sanitizer of undefined behaviour on.
set(wasm_flags "-target wasm32-wasi -mcpu=generic+exception_handling+bulk_memory\
+nontrapping_fptoint+sign_ext+simd128 -fwasm-exceptions -mllvm -wasm-use-legacy-eh=true\
 -fno-sanitize=all -g0")
set(CMAKE_C_FLAGS_INIT "${wasm_flags}")
set(CMAKE_CXX_FLAGS_INIT "${wasm_flags}")
