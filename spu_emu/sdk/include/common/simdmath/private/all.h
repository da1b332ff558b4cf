/* All functions of the SIMD math library. */
#ifndef SPU_EMU_SIMDMATH_ALL_H
#define SPU_EMU_SIMDMATH_ALL_H

#include "simdmath/private/d2_erf.h"
#include "simdmath/private/d2_gamma.h"
#include "simdmath/private/d2_hyperbolic.h"
#include "simdmath/private/d2_remainder.h"
#include "simdmath/private/d2_trig.h"
#include "simdmath/private/f4_arc.h"
#include "simdmath/private/f4_compare.h"
#include "simdmath/private/f4_erf.h"
#include "simdmath/private/f4_exponent.h"
#include "simdmath/private/f4_gamma.h"
#include "simdmath/private/f4_hyperbolic.h"
#include "simdmath/private/f4_power.h"
#include "simdmath/private/f4_remainder.h"
#include "simdmath/private/f4_round.h"
#include "simdmath/private/f4_sign.h"
#include "simdmath/private/f4_trig.h"
#include "simdmath/private/integers.h"

#endif
