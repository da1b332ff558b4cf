// changes.c
#include <cellsweep/c.h>
#include <stdio.h>

// Ten bodies in a row, of which each touches the next; then they part by more and more.
static cellsweep_status spread(cellsweep_broadphase* world, float gap, cellsweep_failure* why) {
  cellsweep_aabb boxes[10];
  uint32_t ids[10];
  for (unsigned i = 0; i < 10; ++i) {
    const float x = (float)i * (1 + gap * (float)i);
    boxes[i] = (cellsweep_aabb){{x, 0, 0}, {x + 1, 1, 1}};
    ids[i] = 100 + i;
  }
  const cellsweep_ids who = cellsweep_ids_of(ids, 10);
  return cellsweep_contains(world, 100)
             ? cellsweep_move(world, who, cellsweep_boxes_of(boxes, 10), why)
             : cellsweep_insert(world, who, cellsweep_boxes_of(boxes, 10), cellsweep_no_filters(), why);
}

int main(void) {
  cellsweep_failure why;
  cellsweep_broadphase* world = NULL;
  cellsweep_history* history = NULL;
  cellsweep_pair_list* list = NULL;
  cellsweep_changes changes;
  if (cellsweep_create(NULL, &world, &why) || cellsweep_history_create(100000, &history, &why)) goto failed;
  if (cellsweep_pair_list_create(&list, &why)) goto failed;

  for (int frame = 0; frame < 3; ++frame) {
    if (spread(world, 0.01F * (float)frame, &why) || cellsweep_update(world, &changes, &why)) goto failed;
    const uint64_t number = cellsweep_statistics_of(world).updates;
    if (cellsweep_history_record(history, number, &changes, &why)) goto failed;
    if (frame > 0) continue;
    const uint32_t some[] = {100, 105};
    size_t count;
    if (cellsweep_find_pairs_of(world, cellsweep_ids_of(some, 2), list, &why)) goto failed;
    cellsweep_listed_pairs(list, &count);
    printf("bodies 100 and 105 are in %zu pairs\n", count);
  }
  // One who looked last after the first update asks what he missed.
  if (cellsweep_history_since(history, 1, &changes, &why)) goto failed;
  printf("since then %zu began, %zu ended\n", changes.began_count, changes.ended_count);
  cellsweep_pair_list_destroy(list);
  cellsweep_history_destroy(history);
  cellsweep_destroy(world);
  return 0;

failed:
  fprintf(stderr, "%s\n", why.message);
  return 1;
}
