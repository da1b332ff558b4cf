// The C library's math.h, with the SPU's idea of the largest float: single precision has no infinity there,
// and HUGE_VALF is what arithmetic saturates to. That is the largest float of this machine here.
#ifndef SPU_EMU_LIBC_MATH_H
#define SPU_EMU_LIBC_MATH_H

#include_next <math.h>

#undef HUGE_VALF
#define HUGE_VALF __FLT_MAX__
#undef INFINITY
#define INFINITY __FLT_MAX__

#endif
