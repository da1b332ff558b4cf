// game_loop.c: discs that bounce about a table, sixty steps a second. Each step the broadphase is told where
// the discs are and says which pairs of boxes overlap; the game looks closer at these and at no others.
#include <cellsweep/c.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { DISCS = 2000, STEPS = 600 };
static const float WIDTH = 120, HEIGHT = 80, STEP = 1 / 60.0F;

struct disc {
  uint32_t id;
  float x, y, radius;
  float vx, vy;  // a second
};

struct box {
  float min[2], max[2];
};

struct game {
  struct disc discs[DISCS];
  struct box boxes[DISCS];
  cellsweep_broadphase* world;
  unsigned long hits;
};

static float between(float low, float high) {
  return low + (high - low) * (float)rand() / (float)RAND_MAX;
}

// Where the discs are, as the library reads it: ids in the discs, boxes in two dimensions in an array of
// their own.
static cellsweep_ids ids_of(const struct game* game) {
  const cellsweep_ids ids = {&game->discs[0].id, sizeof game->discs[0], DISCS};
  return ids;
}

static cellsweep_boxes boxes_of(const struct game* game) {
  return cellsweep_boxes_apart(CELLSWEEP_FLOAT, 2, game->boxes[0].min, game->boxes[0].max,
                               sizeof game->boxes[0], DISCS);
}

static void put_into_boxes(struct game* game) {
  for (int i = 0; i < DISCS; ++i) {
    const struct disc* disc = &game->discs[i];
    game->boxes[i] = (struct box){{disc->x - disc->radius, disc->y - disc->radius},
                                  {disc->x + disc->radius, disc->y + disc->radius}};
  }
}

static cellsweep_status start(struct game* game, cellsweep_failure* why) {
  srand(1);
  for (uint32_t i = 0; i < DISCS; ++i) {
    game->discs[i] = (struct disc){i,
                                   between(1, WIDTH - 1),
                                   between(1, HEIGHT - 1),
                                   between(0.2F, 0.6F),
                                   between(-9, 9),
                                   between(-9, 9)};
  }
  put_into_boxes(game);
  const cellsweep_status status = cellsweep_create(NULL, &game->world, why);
  return status ? status
                : cellsweep_insert(game->world, ids_of(game), boxes_of(game), cellsweep_no_filters(), why);
}

static void move(struct disc* disc) {
  disc->x += disc->vx * STEP;
  disc->y += disc->vy * STEP;
  if (disc->x < disc->radius || disc->x > WIDTH - disc->radius)
    disc->vx = copysignf(disc->vx, WIDTH / 2 - disc->x);
  if (disc->y < disc->radius || disc->y > HEIGHT - disc->radius)
    disc->vy = copysignf(disc->vy, HEIGHT / 2 - disc->y);
}

// The narrow phase: discs that touch and come nearer exchange what they have of each other's way. True for a
// hit.
static bool collide(struct disc* a, struct disc* b) {
  const float x = b->x - a->x, y = b->y - a->y;
  const float reach = a->radius + b->radius;
  const float square = x * x + y * y;
  const float approach = (b->vx - a->vx) * x + (b->vy - a->vy) * y;
  if (square > reach * reach || approach >= 0) return false;
  const float change = approach / square;
  a->vx += change * x;
  a->vy += change * y;
  b->vx -= change * x;
  b->vy -= change * y;
  return true;
}

static cellsweep_status step(struct game* game, cellsweep_failure* why) {
  for (int i = 0; i < DISCS; ++i) move(&game->discs[i]);
  put_into_boxes(game);
  cellsweep_status status = cellsweep_move(game->world, ids_of(game), boxes_of(game), why);
  if (!status) status = cellsweep_update(game->world, NULL, why);
  const cellsweep_pair* pairs = NULL;
  size_t count = 0;
  if (!status) status = cellsweep_pairs(game->world, &pairs, &count, why);
  for (size_t i = 0; i < count; ++i) {
    game->hits += collide(&game->discs[pairs[i].a], &game->discs[pairs[i].b]) ? 1 : 0;
  }
  return status;
}

// What lies first on the way across the table, as a laser or a mouse would ask.
static cellsweep_status look_across(const struct game* game, cellsweep_failure* why) {
  const cellsweep_path ray = cellsweep_ray((float[3]){0, HEIGHT / 2, 0}, (double[3]){1, 0, 0});
  cellsweep_first_touch first;
  const cellsweep_status status = cellsweep_first_touches(game->world, &ray, 1, NULL, &first, why);
  if (!status && first.is_there)
    printf("across the table disc %u is first, at %.1f\n", first.touch.body, first.touch.time);
  return status;
}

int main(void) {
  static struct game game;
  cellsweep_failure why;
  cellsweep_status status = start(&game, &why);
  for (int i = 0; i < STEPS && !status; ++i) status = step(&game, &why);
  if (!status) status = look_across(&game, &why);
  if (status)
    fprintf(stderr, "%s\n", why.message);
  else
    printf("%d steps of %d discs, %lu hits\n", STEPS, DISCS, game.hits);
  cellsweep_destroy(game.world);
  return status != CELLSWEEP_OK;
}
