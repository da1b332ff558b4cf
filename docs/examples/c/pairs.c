// pairs.c
#include <cellsweep/c.h>
#include <stdio.h>

static bool print_pair(void* context, cellsweep_pair pair) {
  printf("%s %u and %u\n", (const char*)context, pair.a, pair.b);
  return true;  // go on
}

int main(void) {
  // Two rectangles of doubles that overlap and one apart, an array for each coordinate; and one of another
  // layer.
  const double min_x[] = {0, 1, 5}, max_x[] = {2, 3, 6}, min_y[] = {0, 0, 0}, max_y[] = {1, 1, 1};
  const ptrdiff_t step = sizeof(double);
  const cellsweep_boxes parts = {.count = 3,
                                 .axes = 2,
                                 .number = CELLSWEEP_DOUBLE,
                                 .min = {{min_x, step}, {min_y, step}},
                                 .max = {{max_x, step}, {max_y, step}}};
  const double hole[] = {2.5, 0.5, 5.5, 0.75};  // x and y of the minimum, then of the maximum
  const cellsweep_boxes holes = cellsweep_boxes_apart(CELLSWEEP_DOUBLE, 2, hole, hole + 2, sizeof hole, 1);

  cellsweep_failure why;
  cellsweep_pair_list* list = NULL;
  uint64_t among, between;
  size_t count;
  const cellsweep_find_options options = {.size = sizeof options, .max_pairs = 1000};
  if (cellsweep_pair_list_create(&list, &why)) goto failed;
  if (cellsweep_find_pairs(parts, &options, list, &why)) goto failed;
  const cellsweep_pair* pairs = cellsweep_listed_pairs(list, &count);
  printf("%zu pair: %u and %u\n", count, pairs[0].a, pairs[0].b);
  if (cellsweep_find_pairs_between(parts, holes, NULL, list, &why)) goto failed;
  pairs = cellsweep_listed_pairs(list, &count);
  for (size_t i = 0; i < count; ++i) printf("part %u has hole %u\n", pairs[i].a, pairs[i].b);

  // The same without a list: counted, or one at a time.
  if (cellsweep_count_pairs(parts, NULL, &among, &why)) goto failed;
  if (cellsweep_count_pairs_between(parts, holes, NULL, &between, &why)) goto failed;
  printf("%d among, %d between\n", (int)among, (int)between);
  if (cellsweep_visit_pairs(parts, NULL, print_pair, "parts", &why)) goto failed;
  if (cellsweep_visit_pairs_between(holes, parts, NULL, print_pair, "hole and part", &why)) goto failed;
  cellsweep_pair_list_destroy(list);
  return 0;

failed:
  fprintf(stderr, "%s\n", why.message);
  cellsweep_pair_list_destroy(list);
  return 1;
}
