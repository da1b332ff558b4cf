// bodies.c
#include <cellsweep/c.h>
#include <stdio.h>

enum { LEVEL = 1, PLAYER = 2, SHOT = 4 };

int main(void) {
  cellsweep_failure why;
  cellsweep_broadphase* world = NULL;
  const cellsweep_stream_options options = {.size = sizeof options, .threads = 2};
  if (cellsweep_create(&options, &world, &why) != CELLSWEEP_OK) goto failed;

  // The library hands out ids. All meet all until a filter says otherwise.
  cellsweep_aabb boxes[4];
  for (int i = 0; i < 4; ++i) boxes[i] = cellsweep_box_at((float)i / 4, 0, 0);
  for (int i = 0; i < 4; ++i) boxes[i].max[0] += 1;
  uint32_t ids[4];
  if (cellsweep_add(world, cellsweep_boxes_of(boxes, 4), ids, &why) != CELLSWEEP_OK) goto failed;
  const cellsweep_filter filters[4] = {{LEVEL, PLAYER | SHOT, true},
                                       {LEVEL, PLAYER | SHOT, true},
                                       {PLAYER, LEVEL | SHOT, false},
                                       {SHOT, LEVEL | PLAYER, false}};
  if (cellsweep_set_filters(world, cellsweep_ids_of(ids, 4), cellsweep_filters_of(filters, 4), &why) ||
      cellsweep_update(world, NULL, &why)) {  // CELLSWEEP_OK is 0
    goto failed;
  }
  const cellsweep_pair* pairs;
  size_t count;
  if (cellsweep_pairs(world, &pairs, &count, &why)) goto failed;
  printf("%zu pairs\n", count);

  // What the world holds.
  cellsweep_filter filter;
  cellsweep_aabb box;
  if (cellsweep_filter_of(world, ids[3], &filter, &why)) goto failed;
  if (cellsweep_read_boxes(world, cellsweep_ids_of(&ids[3], 1), &box, &why)) goto failed;
  printf("body %u: category %u, from x = %g\n", ids[3], filter.category, box.min[0]);
  if (cellsweep_remove(world, cellsweep_ids_of(&ids[3], 1), &why)) goto failed;
  printf("%zu of at most %llu bodies, body %u %s\n", cellsweep_size(world),
         (unsigned long long)cellsweep_capacity(world), ids[3],
         cellsweep_contains(world, ids[3]) ? "is one" : "is none");
  cellsweep_destroy(world);
  return 0;

failed:
  fprintf(stderr, "%s\n", why.message);
  cellsweep_destroy(world);
  return 1;
}
