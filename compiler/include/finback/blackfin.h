/* The instructions that C has no words for. finback-cc turns each call into one instruction; there
 * is no function behind the names. Every one of them is ordered with volatile and ordinary memory
 * accesses, except ones, which only computes. What else only computes is in builtins.h. */
#ifndef FINBACK_BLACKFIN_H
#define FINBACK_BLACKFIN_H

#ifdef __cplusplus
extern "C" {
#endif

void __builtin_bfin_csync(void); /* wait for the core's writes to be visible to its own pipeline */
void __builtin_bfin_ssync(void); /* wait for every write to have reached the system */
void __builtin_bfin_idle(void);  /* sleep until an enabled event */
void __builtin_bfin_nop(void);
unsigned __builtin_bfin_cli(void);          /* disable interrupts; the old mask */
void __builtin_bfin_sti(unsigned mask);     /* enable the interrupts of mask */
void __builtin_bfin_raise(unsigned event);  /* a constant, 0..15 */
void __builtin_bfin_excpt(unsigned number); /* a constant, 0..15 */
/* Atomically: was the byte zero? If so it is now locked. Release by writing 0. */
int __builtin_bfin_testset(volatile unsigned char* lock);
void __builtin_bfin_prefetch(const void* address); /* a line of the cache: read ahead, */
void __builtin_bfin_flush(const void* address);    /* written back, */
void __builtin_bfin_flushinv(const void* address); /* written back and given up, */
void __builtin_bfin_iflush(const void* address);   /* given up, of instructions */
int __builtin_bfin_sysreg_read(int reg);           /* one of sysreg.h */
void __builtin_bfin_sysreg_write(int reg, int value);
unsigned __builtin_bfin_ones(unsigned value) __attribute__((const)); /* number of bits set */

#ifdef __cplusplus
}
#endif

/* void FINBACK_INTERRUPT handler(void): saves all that it and its callees touch and ends with RTI.
 */
#define FINBACK_INTERRUPT __attribute__((used, annotate("interrupt")))

/* An object's or a function's section, for placement by section. */
#define FINBACK_SECTION(name) __attribute__((section(name)))

#endif
