// Exits with 0 if the constructor of a global object ran before main.
struct Global {
  Global() : value(42) {}
  volatile int value;
};

Global global;

int main() {
  return global.value == 42 ? 0 : 1;
}
