struct Body {
  float x, y, z, mass;
  float vx, vy, vz, fill;
};
enum { kBodies = 12 };
