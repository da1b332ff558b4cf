/// @file
/// The programs that run on the graphics card: boxes and floor in the colours and the light of `render`.
#pragma once

namespace cellsweep::view {

inline constexpr const char* kVersion = "#version 330 core\n";

/// The corners of instance after instance, 36 each: six faces of two triangles, seen from outside.
inline constexpr const char* kBoxVertices = R"(
layout(location = 0) in vec3 centre;
layout(location = 1) in vec3 half_extents;
layout(location = 2) in vec4 orientation;
layout(location = 3) in vec3 color;
uniform mat4 to_clip;
invariant gl_Position;
out vec3 place;
out vec3 normal;
out vec2 on_face;
flat out vec2 half_face;
flat out vec3 own_color;

vec3 turned(vec3 v) {
  vec3 axis = orientation.xyz;
  return v + 2.0 * cross(axis, cross(axis, v) + orientation.w * v);
}

void main() {
  const vec2 corners[6] = vec2[](vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, -1), vec2(1, 1), vec2(-1, 1));
  int face = gl_VertexID / 6;
  float side = face < 3 ? 1.0 : -1.0;
  int along = face % 3;
  int across = (along + 1) % 3;
  int over = (along + 2) % 3;
  vec2 corner = corners[gl_VertexID % 6] * vec2(side, 1);
  vec3 point = vec3(0);
  point[along] = side;
  normal = turned(point);
  point[across] = corner.x;
  point[over] = corner.y;
  half_face = vec2(half_extents[across], half_extents[over]);
  on_face = corner * half_face;
  own_color = color;
  place = centre + turned(point * half_extents);
  gl_Position = to_clip * vec4(place, 1);
}
)";

/// For the map of what the sun sees: depth only.
inline constexpr const char* kNoColor = "void main() {}\n";

/// What boxes and floor share. Light adds up by the squares of screen colours, more or less.
inline constexpr const char* kLight = R"(
uniform mat4 to_sun_map;
uniform sampler2DShadow sun_map;
uniform mat4 to_sky_map;
uniform sampler2DShadow sky_map;
uniform vec3 to_sun;
uniform float world_size;
const vec3 paper = vec3(0.90, 0.93, 0.96);
const vec3 floor_albedo = vec3(0.60, 0.62, 0.66);
const vec3 sun = vec3(0.86, 0.80, 0.70);
const vec3 sky = vec3(0.46, 0.52, 0.60);
const vec3 shade = vec3(0.11, 0.115, 0.12);

float seen_by_sun(vec3 place, vec3 normal) {
  vec3 at = (to_sun_map * vec4(place + normal * (0.003 * world_size), 1)).xyz * 0.5 + 0.5;
  float seen = 0.0;
  vec2 step = 0.6 / vec2(textureSize(sun_map, 0));
  for (int x = -1; x <= 1; x += 2)
    for (int y = -1; y <= 1; y += 2)
      seen += texture(sun_map, vec3(at.xy + step * vec2(x, y), at.z - 0.0008));
  return seen / 4.0;
}

// A wide look straight up stands for the sky's half sphere.
float seen_by_sky(vec3 place, vec3 normal) {
  vec3 at = (to_sky_map * vec4(place + normal * (0.012 * world_size), 1)).xyz * 0.5 + 0.5;
  float seen = 0.0;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      seen += texture(sky_map, vec3(at.xy + 0.02 * vec2(x, y), at.z - 0.004));
  return seen / 9.0;
}

vec3 lit(vec3 albedo, vec3 place, vec3 normal) {
  vec3 light = shade + sun * max(dot(normal, to_sun), 0.0) * seen_by_sun(place, normal);
  float upward = 0.5 + 0.5 * normal.y;
  light += sky * 0.98 * upward * mix(0.35, 1.0, seen_by_sky(place, normal));
  light += floor_albedo * 0.22 * (1.0 - upward);
  return albedo * light;
}

// Bright light is compressed, not cut off; the square root stands for sRGB's curve.
vec4 on_screen(vec3 light) {
  vec3 compressed = light * (1.0 + 0.12 * light) / (1.0 + 0.22 * light);
  return vec4(sqrt(clamp(compressed, 0.0, 1.0)), 1);
}
)";

/// For what knows no light.
inline constexpr const char* kWorldSize = "uniform float world_size;\n";

/// A fine dark line along its edges tells a box from the one behind.
inline constexpr const char* kBoxEdges = R"(
in vec2 on_face;
flat in vec2 half_face;

float darkened_at_edges() {
  vec2 to_edges = half_face - abs(on_face);
  float to_edge = min(to_edges.x, to_edges.y);
  float width = 0.0013 * world_size;
  float blur = max(fwidth(to_edge), 1e-7);
  return mix(0.45, 1.0, smoothstep(width - blur, width + blur, to_edge));
}
)";

inline constexpr const char* kBoxColor = R"(
in vec3 place;
in vec3 normal;
flat in vec3 own_color;
out vec4 pixel;

void main() {
  pixel = on_screen(lit(own_color * own_color * darkened_at_edges(), place, normalize(normal)));
}
)";

/// In no light but its own, and seen through a little: over what is in front of it.
inline constexpr const char* kGlowColor = R"(
in vec3 normal;
flat in vec3 own_color;
out vec4 pixel;

void main() {
  float facing = 0.86 + 0.14 * normalize(normal).y;
  pixel = vec4(own_color * facing * darkened_at_edges(), 0.82);
}
)";

/// The twelve edges of instance after instance, two ends each: four along every axis.
inline constexpr const char* kEdgeVertices = R"(
layout(location = 0) in vec3 low;
layout(location = 1) in vec3 high;
layout(location = 2) in vec3 color;
uniform mat4 to_clip;
flat out vec3 own_color;

void main() {
  int along = gl_VertexID / 8;
  int edge = (gl_VertexID / 2) % 4;
  vec3 side = vec3(0);
  side[along] = float(gl_VertexID % 2);
  side[(along + 1) % 3] = float(edge % 2);
  side[(along + 2) % 3] = float(edge / 2);
  own_color = color;
  gl_Position = to_clip * vec4(mix(low, high, side), 1);
}
)";

inline constexpr const char* kLineColor = R"(
flat in vec3 own_color;
out vec4 pixel;

void main() {
  pixel = vec4(own_color, 0.7);
}
)";

/// A square on the world's floor, much larger than the world.
inline constexpr const char* kFloorVertices = R"(
uniform mat4 to_clip;
uniform vec3 world_min;
uniform vec3 world_max;
uniform float world_size;
out vec3 place;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec3 middle = 0.5 * (world_min + world_max);
  place = vec3(middle.x + 1.8 * world_size * corner.x, world_min.y, middle.z - 1.8 * world_size * corner.y);
  gl_Position = to_clip * vec4(place, 1);
}
)";

/// Lines every tenth of the world inside of it; the floor fades away instead of having an end.
inline constexpr const char* kFloorColor = R"(
uniform vec3 world_min;
uniform vec3 world_max;
in vec3 place;
out vec4 pixel;

float off_lines(vec2 cell) {
  vec2 away = abs(cell - floor(cell + 0.5));
  vec2 blur = max(fwidth(cell), 1e-6);
  vec2 off = smoothstep(vec2(0.016) - blur, vec2(0.016) + blur, away);
  return off.x * off.y;
}

void main() {
  vec3 middle = 0.5 * (world_min + world_max);
  float away = length(place.xz - middle.xz) / world_size;
  float fade = clamp((away - 0.75) / 0.9, 0.0, 1.0);
  bool inside = all(greaterThan(place.xz, world_min.xz)) && all(lessThan(place.xz, world_max.xz));
  float off = off_lines(10.0 * (place.xz - world_min.xz) / world_size);
  vec3 albedo = floor_albedo * (0.62 + 0.38 * (inside ? off : 1.0));
  pixel = on_screen(mix(lit(albedo, place, vec3(0, 1, 0)), paper, fade));
}
)";

}  // namespace cellsweep::view
