/* The C library's setjmp.h, in runtime/setjmp.bir: what a callee keeps, SP and the return address.
 * As everywhere, locals changed after setjmp() are lost unless they are volatile. */
#ifndef FINBACK_SETJMP_H
#define FINBACK_SETJMP_H

#ifdef __cplusplus
extern "C" {
#endif

typedef unsigned jmp_buf[10];

int setjmp(jmp_buf place) __attribute__((returns_twice));
_Noreturn void longjmp(jmp_buf place, int value);

#ifdef __cplusplus
}
#endif

#endif
