#include <libspe2.h>

#include <cmath>
#include <cstdio>

#include "body.h"

extern "C" spe_program_handle_t bodies;
static Body mine[kBodies], theirs[kBodies] __attribute__((aligned(128)));

static void step_here() {
  const float dt = 0.01f;
  for (int i = 0; i < kBodies; ++i) {
    for (int j = 0; j < kBodies; ++j) {
      const float dx = mine[j].x - mine[i].x, dy = mine[j].y - mine[i].y, dz = mine[j].z - mine[i].z;
      const float pull = mine[j].mass * std::pow(dx * dx + dy * dy + dz * dz + 0.01f, -1.5f) * dt;
      mine[i].vx += dx * pull, mine[i].vy += dy * pull, mine[i].vz += dz * pull;
    }
  }
  for (int i = 0; i < kBodies; ++i) {
    mine[i].x += mine[i].vx * dt, mine[i].y += mine[i].vy * dt, mine[i].z += mine[i].vz * dt;
  }
}

int main() {
  for (int i = 0; i < kBodies; ++i) {
    Body body = {float(i % 3), float(i / 3), float(i * i % 5), 1 + 0.1f * i, 0, 0, 0, 0};
    mine[i] = theirs[i] = body;
  }
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_context_ptr_t spe = spe_context_create(0, 0);
  spe_program_load(spe, &bodies);
  if (spe_context_run(spe, &entry, 0, theirs, (void*)20, 0) != 0) return 1;
  for (int i = 0; i < 20; ++i) step_here();
  float apart = 0, momentum = 0;
  for (int i = 0; i < kBodies; ++i) {
    apart = std::fmax(apart, std::fabs(mine[i].x - theirs[i].x) + std::fabs(mine[i].y - theirs[i].y));
    momentum += theirs[i].mass * theirs[i].vx;
  }
  std::printf("%s, momentum %s\n", apart < 1e-3f ? "as the host has it" : "APART", std::fabs(momentum) < 1e-2f ? "kept" : "LOST");
  std::printf("the first is at %.2f %.2f %.2f\n", theirs[0].x, theirs[0].y, theirs[0].z);
}
