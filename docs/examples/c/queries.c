// queries.c
#include <cellsweep/c.h>
#include <stdio.h>

static bool is_even(void* context, uint32_t id) {
  (void)context;
  return id % 2 == 0;
}

static bool count_body(void* context, uint32_t id) {
  (void)id;
  ++*(int*)context;
  return true;  // go on
}

static double keep_nearest(void* context, cellsweep_touch touch, double end) {
  (void)end;
  *(cellsweep_touch*)context = touch;
  return touch.time;  // only what is nearer is of interest from now on
}

// Cubes with an edge of 1 in a row along x, from 0, 3, 6, ...
static cellsweep_status fill(cellsweep_broadphase* world, cellsweep_failure* why) {
  cellsweep_aabb boxes[10];
  uint32_t ids[10];
  for (unsigned i = 0; i < 10; ++i) {
    boxes[i] = cellsweep_box_at(3.0F * (float)i, 0, 0);
    for (int axis = 0; axis < 3; ++axis) boxes[i].max[axis] += 1;
    ids[i] = i;
  }
  const cellsweep_status status = cellsweep_insert(
      world, cellsweep_ids_of(ids, 10), cellsweep_boxes_of(boxes, 10), cellsweep_no_filters(), why);
  return status ? status : cellsweep_update(world, NULL, why);
}

// Lists, with memory that serves again.
static cellsweep_status ask_for_lists(const cellsweep_broadphase* world, cellsweep_answers* answers,
                                      cellsweep_failure* why) {
  size_t count;
  const cellsweep_region regions[2] = {cellsweep_sphere(4, 0, 0, 3),
                                       cellsweep_box_region(cellsweep_box_at(9, 1, 1))};
  cellsweep_status status = cellsweep_find_overlaps(world, regions, 2, NULL, answers, why);
  if (status) return status;
  for (size_t i = 0; i < 2; ++i) {
    const uint32_t* bodies = cellsweep_bodies(answers, i, &count);
    printf("region %zu: %zu bodies, the first is %u\n", i, count, bodies[0]);
  }
  const cellsweep_query_filter even = {.predicate = is_even};
  const cellsweep_path ray = cellsweep_ray((float[3]){-5, 0.5F, 0.5F}, (double[3]){1, 0, 0});
  status = cellsweep_find_touches(world, &ray, 1, &even, answers, why);
  if (status) return status;
  const cellsweep_touch* touches = cellsweep_touches(answers, 0, &count);
  printf("even ones on the ray: %zu, the second is %u after %g\n", count, touches[1].body, touches[1].time);
  const cellsweep_aabb here = cellsweep_box_at(5, 0, 0);
  status = cellsweep_find_nearest(world, &here, 1, 2, INFINITY, NULL, answers, why);
  if (status) return status;
  const cellsweep_neighbor* near = cellsweep_neighbors(answers, 0, &count);
  printf("nearest: %u at %g, then %u at %g\n", near[0].body, near[0].distance, near[1].body,
         near[1].distance);
  status = cellsweep_find_within(world, regions, 1, NULL, answers, why);
  if (status) return status;
  near = cellsweep_neighbors(answers, 0, &count);
  printf("within the sphere: %zu, the last is %u at %g\n", count, near[count - 1].body,
         near[count - 1].distance);
  return status;
}

// One answer for each of several questions.
static cellsweep_status ask_for_one(const cellsweep_broadphase* world, cellsweep_failure* why) {
  const cellsweep_path paths[2] = {cellsweep_segment((float[3]){1.5F, 0, 0}, (float[3]){2.5F, 0, 0}),
                                   cellsweep_moving_box(cellsweep_box_at(2, 0, 0), (double[3]){4, 0, 0})};
  cellsweep_first_touch first[2];
  bool any[2];
  cellsweep_status status = cellsweep_first_touches(world, paths, 2, NULL, first, why);
  if (!status) status = cellsweep_any_touches(world, paths, 2, NULL, any, why);
  if (status) return status;
  for (int i = 0; i < 2; ++i) {
    if (any[i])
      printf("path %d: body %u after %g\n", i, first[i].touch.body, first[i].touch.time);
    else
      printf("path %d: nothing\n", i);
  }
  const cellsweep_region region = cellsweep_sphere(0, 9, 0, 7.5);
  status = cellsweep_any_overlaps(world, &region, 1, NULL, any, why);
  if (!status) printf("the high sphere %s a body\n", any[0] ? "touches" : "does not touch");
  return status;
}

// One body at a time.
static cellsweep_status visit(const cellsweep_broadphase* world, cellsweep_failure* why) {
  const cellsweep_region all = cellsweep_sphere(0, 0, 0, INFINITY);
  int bodies = 0;
  cellsweep_status status = cellsweep_visit_overlaps(world, &all, NULL, count_body, &bodies, why);
  if (status) return status;
  const cellsweep_path ray = cellsweep_ray((float[3]){40, 0.5F, 0.5F}, (double[3]){-1, 0, 0});
  cellsweep_touch nearest = {0, 0};
  status = cellsweep_visit_touches(world, &ray, NULL, keep_nearest, &nearest, why);
  if (!status) printf("%d bodies; from behind it is %u after %g\n", bodies, nearest.body, nearest.time);
  return status;
}

int main(void) {
  cellsweep_failure why;
  cellsweep_broadphase* world = NULL;
  cellsweep_answers* answers = NULL;
  const bool failed = cellsweep_create(NULL, &world, &why) || cellsweep_answers_create(&answers, &why) ||
                      fill(world, &why) ||
                      cellsweep_prepare_queries(world, &why) ||  // optional: many questions will follow
                      ask_for_lists(world, answers, &why) || ask_for_one(world, &why) || visit(world, &why);
  if (failed) fprintf(stderr, "%s\n", why.message);
  cellsweep_answers_destroy(answers);
  cellsweep_destroy(world);
  return failed;
}
