// OpenCL's C++ bindings with the settings that all of Lacuna needs: exceptions, and kernels of
// OpenCL C 1.2. They take long to compile: for the .cpp files of this folder only.
#pragma once

#define CL_HPP_ENABLE_EXCEPTIONS
#define CL_HPP_MINIMUM_OPENCL_VERSION 200
#define CL_HPP_TARGET_OPENCL_VERSION 200

#include "backends/opencl/entry_points.h"  // first: it renames what the bindings call

#include <CL/opencl.hpp>
