// `vector` as a keyword before built-in types, and as a name like others everywhere else.
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

#include <vector>

using namespace std;

namespace {

struct Arrow {
  float vector[3];
};

template <class T>
T twice(const T& vector) {
  return vector + vector;
}

vector float make(float vector) {
  return spu_splats(vector);
}

}  // namespace

int main() {
  std::vector<unsigned int> one(3, 7U);
  vector<int> two(2, 5);
  Arrow arrow{{1, 2, 3}};
  vector unsigned int words = {0x10203, 0x4050607, 0x8090a0b, 0xc0d0e0f};
  const vector signed short* halves = nullptr;
  vector unsigned int mask = spu_cmpgt(words, 0x5000000U);
  vector unsigned char bytes = spu_splats(static_cast<unsigned char>(1));
  __vector float floats = make(arrow.vector[1]);
  int vector = static_cast<int>(one.size() + two.size());
  const bool sizes = sizeof(vector unsigned int) == 16 && sizeof(vector) == 4 && halves == nullptr;
  const bool values = spu_extract(mask, 1) == 0 && spu_extract(mask, 2) == ~0U &&
                      spu_extract(bytes, 9) == 1 && spu_extract(twice(floats), 3) == 4.0F;
  return sizes && values ? vector : 0;
}
