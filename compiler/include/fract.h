/* Types and arithmetic of fractions, and their conversions. */
#ifndef FRACT_H
#define FRACT_H

#include <fract2float_conv.h>
#include <fract_math.h>
#include <fract_typedef.h>

#endif
