/* The two cores, as numbers. */
#ifndef FINBACK_CORE_H
#define FINBACK_CORE_H

enum core { CORE_A = 0, CORE_B = 1 };

#endif
