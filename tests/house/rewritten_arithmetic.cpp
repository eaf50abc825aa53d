// Does check_environment() see what an option lets the compiler do to the calling code?  Ends with 1 where it does.
#include "plumb/certify/environment.hpp"

int main() { return plumb::certify::environment::fast_math_here() ? 1 : 0; }
