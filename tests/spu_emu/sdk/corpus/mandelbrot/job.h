struct Job {
  unsigned long long counter, image;
  int width, height, limit, fill;
} __attribute__((aligned(16)));
