// The version of Lacuna. CMake, the Python module and the page read it from here.
#pragma once

#define LACUNA_VERSION "0.1.0"
