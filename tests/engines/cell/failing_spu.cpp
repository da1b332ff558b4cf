// An SPU program that does nothing it is asked to.
int main(unsigned long long, unsigned long long, unsigned long long) {
  return 7;
}
