typedef struct {
  float floats[4][4];
  double doubles[4][2];
} results;
