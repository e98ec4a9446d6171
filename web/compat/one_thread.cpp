// Stands in for host/threads.cpp: the stand-in for oneTBB makes no threads.
#include "threads.h"

namespace lacuna {

void make_sure_of_threads(int) {}
void make_sure_of_threads() {}

}  // namespace lacuna
