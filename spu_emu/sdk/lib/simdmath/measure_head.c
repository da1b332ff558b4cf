/* The arguments of the program that measure makes. */
#include <simdmath.h>

static volatile vec_float4 vec_float4_in = {0.25f, 0.5f, 0.75f, 0.9f};
static volatile vec_int4 vec_int4_in = {3, 5, 7, 11};
static volatile vec_uint4 vec_uint4_in = {3, 5, 7, 11};
static volatile vec_double2 vec_double2_in = {0.25, 0.75};
static volatile vec_llong2 vec_llong2_in = {3, 5};
static volatile vec_ullong2 vec_ullong2_in = {3, 5};

static vec_float4 vec_float4_out;
static vec_int4 vec_int4_out;
static vec_double2 vec_double2_out;
static vec_llong2 vec_llong2_out;

