#define N 64
#define PER_ROW 4

struct matrix {
  float values[N][PER_ROW];
  unsigned int columns[N][PER_ROW];
  float x[N][4]; /* an element of the vector is a quadword, so that a list can gather it */
  float y[N];
};
