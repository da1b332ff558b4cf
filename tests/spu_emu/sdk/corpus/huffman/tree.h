#define SYMBOLS 8
struct tree {
  char text[256];
  unsigned int count[2 * SYMBOLS];
  unsigned int length[2 * SYMBOLS];
};
