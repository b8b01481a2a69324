/* moves.h - moves of vectors between registers and memory, on Windows with gcc.
 *
 * A stack is aligned to 16 bytes there; gcc nevertheless moves what it keeps on it by instructions that
 * stop the program unless 32 or 64 bytes are aligned (gcc's bug 54412; other compilers align the stack).  The
 * macros make the assembler take the instructions for any address, which are as fast at an aligned one.  With
 * -flto, which may separate them from the functions, give -Wa,-muse-unaligned-vector-move as well.
 */
#ifndef ALGSURF_MOVES_H
#define ALGSURF_MOVES_H
#if defined(_WIN64) && defined(__GNUC__) && !defined(__clang__)
#define ALGSURF_MOVE(aligned, any) __asm__(".macro " aligned " operands:vararg\n" any " \\operands\n.endm\n");
ALGSURF_MOVE("vmovapd", "vmovupd")
ALGSURF_MOVE("vmovaps", "vmovups")
ALGSURF_MOVE("vmovdqa", "vmovdqu")
ALGSURF_MOVE("vmovdqa32", "vmovdqu32")
ALGSURF_MOVE("vmovdqa64", "vmovdqu64")
#undef ALGSURF_MOVE
#endif
#endif
