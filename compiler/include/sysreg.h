/* System registers by name, for sysreg_read and sysreg_write: reg_CYCLES and so on. Those that the
 * compiler works with (accumulators, loop and index registers, stack) are not among them. */
#ifndef SYSREG_H
#define SYSREG_H

#include <finback/blackfin.h>

#define reg_ASTAT 0
#define reg_SEQSTAT 1
#define reg_SYSCFG 2
#define reg_RETI 3
#define reg_RETX 4
#define reg_RETN 5
#define reg_RETE 6
#define reg_USP 7
#define reg_CYCLES 8
#define reg_CYCLES2 9

/* Macros: the register is a constant. */
#define sysreg_read(reg) ((unsigned)__builtin_bfin_sysreg_read(reg))
#define sysreg_write(reg, value) __builtin_bfin_sysreg_write((reg), (int)(value))

#endif
