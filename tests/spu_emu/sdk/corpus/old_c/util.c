#include <stdio.h>
#include "globals.h"

inline twice(x)
     int x;
{
  return 2 * x;
}

print_table(table, n)
     int *table, n;
{
  register i;
  calls++;
  for (i = 0; i < n; i++)
    printf("%d%c", table[i], i == n - 1 ? '\n' : ' ');
}
