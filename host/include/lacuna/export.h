// What a shared library of Lacuna exports: all that the public headers declare.
#pragma once

#if defined(__GNUC__)
#define LACUNA_API [[gnu::visibility("default")]]
#else
#define LACUNA_API
#endif
