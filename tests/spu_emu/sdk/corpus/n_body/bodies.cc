// Gravity among a few bodies; the square root's reciprocal is the SPU's estimate with two steps of Newton's.
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

#include "body.h"

template <class T, int count>
class Buffer {
 public:
  explicit Buffer(unsigned long long ea) : ea_(ea) { move(MFC_GET_CMD); }
  ~Buffer() { move(MFC_PUT_CMD); }
  T& operator[](int i) { return data_[i]; }

 private:
  void move(unsigned int command) {
    spu_mfcdma64(data_, mfc_ea2h(ea_), mfc_ea2l(ea_), sizeof data_, 0, command);
    mfc_write_tag_mask(1);
    mfc_read_tag_status_all();
  }
  T data_[count] __attribute__((aligned(128)));
  unsigned long long ea_;
};

static float inverse_root(float square) {
  const vec_float4 x = spu_promote(square, 0), half = spu_mul(x, spu_splats(0.5f));
  vec_float4 y = spu_rsqrte(x);
  for (int i = 0; i < 2; ++i) y = spu_mul(y, spu_nmsub(spu_mul(half, y), y, spu_splats(1.5f)));
  return spu_extract(y, 0);
}

int main(unsigned long long, unsigned long long ea, unsigned long long steps) {
  Buffer<Body, kBodies> bodies(ea);
  const float dt = 0.01f;
  for (unsigned long long step = 0; step < steps; ++step) {
    for (int i = 0; i < kBodies; ++i) {
      Body& a = bodies[i];
      for (int j = 0; j < kBodies; ++j) {
        const Body& b = bodies[j];
        const float dx = b.x - a.x, dy = b.y - a.y, dz = b.z - a.z;
        const float inverse = inverse_root(dx * dx + dy * dy + dz * dz + 0.01f);
        const float pull = b.mass * inverse * inverse * inverse * dt;
        a.vx += dx * pull, a.vy += dy * pull, a.vz += dz * pull;
      }
    }
    for (int i = 0; i < kBodies; ++i) {
      Body& a = bodies[i];
      a.x += a.vx * dt, a.y += a.vy * dt, a.z += a.vz * dt;
    }
  }
  return 0;
}
