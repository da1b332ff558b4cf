/* As old programs have it: what they print with is declared by libspe2.h. */
#include <libspe2.h>

int main(void) { return printf("%d SPEs or more\n", spe_cpu_info_get(SPE_COUNT_PHYSICAL_SPES, -1) > 0) < 0; }
