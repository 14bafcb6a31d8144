/* Fractions: 1.15 and 1.31, in integers. A pair has its first half in bits 16 to 31. */
#ifndef FRACT_TYPEDEF_H
#define FRACT_TYPEDEF_H

typedef short fract16;
typedef int fract32; /* long in the vendor's headers: the same 32 bits */
typedef int fract2x16;
typedef fract2x16 fr2x16;

#endif
