// SPDX-License-Identifier: MIT
// The tag that all C++ exceptions of the module are thrown with: LLVM no longer defines one in each
// object.
__asm__(
    ".globl __cpp_exception\n"
    ".tagtype __cpp_exception i32\n"
    "__cpp_exception:\n");
