// Contact candidates between deforming meshes, as incremental potential contact (IPC) asks for them in each
// step: vertices and triangles, each in the box around its way through the step, grown by half the distance
// at which contact begins. One call finds the pairs; the distance of a vertex from a triangle is only
// computed for these.
#include <cellsweep/find_pairs.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

using Vector = std::array<double, 3>;
using Box = cellsweep::Box<double, 3>;

Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector operator*(double s, const Vector& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct Mesh {
  std::vector<Vector> start;  // where vertices are when the step begins
  std::vector<Vector> end;    // and ends
  std::vector<std::array<unsigned, 3>> triangles;
};

/// A cloth of n by n squares at a height, which falls, and below it one with waves.
void add_cloth(Mesh& mesh, unsigned n, double height, double fall, double wave) {
  const auto first = static_cast<unsigned>(mesh.start.size());
  for (unsigned i = 0; i <= n; ++i) {
    for (unsigned k = 0; k <= n; ++k) {
      const Vector place = {i * 1.0 / n, k * 1.0 / n,
                            height + wave * std::sin(12.0 * i / n) * std::cos(9.0 * k / n)};
      mesh.start.push_back(place);
      mesh.end.push_back(place + Vector{0, 0, -fall});
    }
  }
  for (unsigned i = 0; i < n; ++i) {
    for (unsigned k = 0; k < n; ++k) {
      const unsigned a = first + i * (n + 1) + k;
      mesh.triangles.push_back({a, a + 1, a + n + 1});
      mesh.triangles.push_back({a + 1, a + n + 2, a + n + 1});
    }
  }
}

/// Around the ways of some vertices.
template <class Vertices>
Box swept_box(const Mesh& mesh, const Vertices& vertices, double margin) {
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.min[axis] = box.max[axis] = mesh.start[vertices[0]][axis];
    for (const unsigned v : vertices) {
      box.min[axis] = std::min({box.min[axis], mesh.start[v][axis], mesh.end[v][axis]});
      box.max[axis] = std::max({box.max[axis], mesh.start[v][axis], mesh.end[v][axis]});
    }
    box.min[axis] -= margin;
    box.max[axis] += margin;
  }
  return box;
}

/// The square of the distance of a point from a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
double square_distance(const Vector& p, const Vector& a, const Vector& b, const Vector& c) {
  const Vector ab = b - a, ac = c - a, ap = p - a;
  const auto to = [&](const Vector& q) { return dot(p - q, p - q); };
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return to(a);
  const double d3 = dot(ab, p - b), d4 = dot(ac, p - b);
  if (d3 >= 0 && d4 <= d3) return to(b);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return to(a + (d1 / (d1 - d3)) * ab);
  const double d5 = dot(ab, p - c), d6 = dot(ac, p - c);
  if (d6 >= 0 && d5 <= d6) return to(c);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return to(a + (d2 / (d2 - d6)) * ac);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) return to(b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b));
  return to(a + (vb / (va + vb + vc)) * ab + (vc / (va + vb + vc)) * ac);
}

/// Whether they are that near when the step begins or ends; a triangle's own vertices are not meant.
bool is_near(const Mesh& mesh, unsigned vertex, unsigned triangle, double distance) {
  const std::array<unsigned, 3>& corners = mesh.triangles[triangle];
  if (std::find(corners.begin(), corners.end(), vertex) != corners.end()) return false;
  const auto square = [&](const std::vector<Vector>& at) {
    return square_distance(at[vertex], at[corners[0]], at[corners[1]], at[corners[2]]);
  };
  return std::min(square(mesh.start), square(mesh.end)) < distance * distance;
}

}  // namespace

int main() {
  Mesh mesh;
  add_cloth(mesh, 40, 0.30, 0.205, 0);
  add_cloth(mesh, 40, 0.05, 0, 0.04);
  constexpr double kDistance = 0.01;

  std::vector<Box> vertices;
  std::vector<Box> triangles;
  for (unsigned v = 0; v < mesh.start.size(); ++v) {
    vertices.push_back(swept_box(mesh, std::array{v}, kDistance / 2));
  }
  for (const auto& triangle : mesh.triangles) triangles.push_back(swept_box(mesh, triangle, kDistance / 2));

  const auto candidates = cellsweep::find_pairs(vertices, triangles);
  if (!candidates) {
    std::fprintf(stderr, "%s\n", candidates.status().message.c_str());
    return 1;
  }
  std::size_t contacts = 0;
  for (const auto& [vertex, triangle] : *candidates)
    contacts += is_near(mesh, vertex, triangle, kDistance) ? 1 : 0;

  // The same without boxes, to see that none was missed.
  std::size_t expected = 0;
  for (unsigned v = 0; v < vertices.size(); ++v) {
    for (unsigned t = 0; t < triangles.size(); ++t) expected += is_near(mesh, v, t, kDistance) ? 1 : 0;
  }
  std::printf("%zu vertices, %zu triangles: %zu candidates, %zu contacts, %zu by looking at all\n",
              vertices.size(), triangles.size(), candidates->size(), contacts, expected);
  return contacts == expected ? 0 : 1;
}
