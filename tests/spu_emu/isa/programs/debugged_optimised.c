// The same, optimised.
#include "debugged.c"
