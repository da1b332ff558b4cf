// own.c
#include <cellsweep/c.h>
#include <stdio.h>
#include <stdlib.h>

// The program's own memory: here it only counts what is out.
static void* take(void* context, size_t bytes, size_t alignment) {
  ++*(int*)context;
  return aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}

static void give(void* context, void* memory) {
  --*(int*)context;
  free(memory);
}

// The program's own job system: here it does one task after the other.
static bool run(void* context, unsigned count, cellsweep_task task, void* task_context) {
  (void)context;
  for (unsigned i = 0; i < count; ++i) task(task_context, i);
  return true;
}

static int fail(const cellsweep_failure* why) {
  fprintf(stderr, "%s\n", why->message);
  return 1;
}

int main(void) {
  cellsweep_failure why;
  int blocks = 0;
  const cellsweep_allocator allocator = {take, give, &blocks};
  if (cellsweep_set_allocator(&allocator, &why)) return fail(&why);  // before everything else
  printf("cellsweep %s\n", cellsweep_version());
  for (size_t i = 0; i < cellsweep_engine_count(); ++i) {
    printf("%s: %s\n", cellsweep_engine_at(i), cellsweep_engine_summary(i));
  }

  const cellsweep_executor jobs = {.concurrency = 4, .run = run};
  const cellsweep_stream_options options = {.size = sizeof options, .executor = &jobs};
  cellsweep_broadphase* worlds[2] = {NULL, NULL};
  const cellsweep_setting setting = {"pair_map_bytes", "1000000"};
  if (cellsweep_create(&options, &worlds[0], &why) ||
      cellsweep_create_engine("control", &setting, 1, &worlds[1], &why)) {
    return fail(&why);
  }
  const cellsweep_aabb boxes[2] = {{{0, 0, 0}, {1, 1, 1}}, {{1, 0, 0}, {2, 1, 1}}};
  for (int i = 0; i < 2; ++i) {
    uint32_t ids[2];
    if (cellsweep_add(worlds[i], cellsweep_boxes_of(boxes, 2), ids, &why) ||
        cellsweep_update(worlds[i], NULL, &why)) {
      return fail(&why);
    }
    const cellsweep_statistics of = cellsweep_statistics_of(worlds[i]);
    fprintf(stderr, "%s compared %llu pairs of boxes, and holds %llu bytes\n",
            cellsweep_engine_name(worlds[i]), (unsigned long long)of.boxes_compared,
            (unsigned long long)of.bytes);
    for (size_t k = 0; k < of.phase_count; ++k) {
      const cellsweep_phase phase = cellsweep_phase_at(worlds[i], k);
      fprintf(stderr, "  %s: %g ms\n", phase.name, phase.milliseconds);
    }
    for (size_t k = 0; k < of.counter_count; ++k) {
      const cellsweep_counter counter = cellsweep_counter_at(worlds[i], k);
      fprintf(stderr, "  %s: %llu\n", counter.name, (unsigned long long)counter.value);
    }
    cellsweep_destroy(worlds[i]);
  }
  printf("%d blocks left\n", blocks);
  return 0;
}
