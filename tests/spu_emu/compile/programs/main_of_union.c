typedef union {
  unsigned long long ull;
  void* p;
} address;

int main(unsigned long long speid, address argp, address envp) {
  return speid != 0 && envp.p == 0 ? (int)argp.ull : 1;
}
