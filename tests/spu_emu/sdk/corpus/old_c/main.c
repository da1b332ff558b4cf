#include <stdio.h>
#include "globals.h"

int table[32] __attribute__((aligned(128)));

main(argc, argv)
     int argc;
     char **argv;
{
  int i;
  program_name = argv[0];
  for (i = 0; i < 32; i++)
    table[i] = twice(i);
  if (run_work(table))
    exit(1);
  print_table(table, 8);
  printf("%d calls\n", calls);
  return 0;
}
