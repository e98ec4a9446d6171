// Replaces host/base/threads.cpp: the page's replacement for oneTBB makes no threads.
#include "base/threads.h"

namespace lacuna {

void make_sure_of_threads(int) {}
void make_sure_of_threads() {}

}  // namespace lacuna
