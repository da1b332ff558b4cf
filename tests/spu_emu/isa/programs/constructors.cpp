// Constructors and destructors of globals, exceptions, virtual functions, the heap.
#include <cstdio>
#include <memory>
#include <vector>

namespace {

struct Announced {
  explicit Announced(const char* name_) : name(name_) { std::printf("+%s\n", name); }
  ~Announced() { std::printf("-%s\n", name); }
  const char* name;
};

Announced first("first");
Announced second("second");

struct Shape {
  virtual ~Shape() {}
  virtual int corners() const = 0;
};
struct Triangle : Shape {
  int corners() const override { return 3; }
};

}  // namespace

int main() {
  const std::unique_ptr<Shape> shape(new Triangle);
  std::vector<int> numbers(100, shape->corners());
  try {
    throw numbers.size();
  } catch (std::size_t count) {
    std::printf("caught %u\n", static_cast<unsigned>(count));
  }
  return numbers.back();
}
