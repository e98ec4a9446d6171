// OpenCL's functions, which the library looks up at their first use: so a program that links Lacuna
// also starts, and runs on other backends, where OpenCL is not installed.
#pragma once

#define CL_TARGET_OPENCL_VERSION 200
#include <CL/opencl.h>

#include <string>

// The functions that the C++ bindings call in this folder; a missing one fails to link.
// clang-format off
#define LACUNA_OPENCL_ENTRIES(ENTRY) \
    ENTRY(clBuildProgram) ENTRY(clCreateBuffer) ENTRY(clCreateCommandQueueWithProperties) \
    ENTRY(clCreateContext) ENTRY(clCreateKernel) ENTRY(clCreateProgramWithSource) \
    ENTRY(clEnqueueFillBuffer) ENTRY(clEnqueueMapBuffer) ENTRY(clEnqueueNDRangeKernel) ENTRY(clEnqueueReadBuffer) \
    ENTRY(clEnqueueUnmapMemObject) ENTRY(clEnqueueWriteBuffer) \
    ENTRY(clFinish) ENTRY(clFlush) ENTRY(clGetDeviceIDs) ENTRY(clGetDeviceInfo) \
    ENTRY(clGetEventProfilingInfo) \
    ENTRY(clGetPlatformIDs) ENTRY(clGetPlatformInfo) ENTRY(clGetProgramBuildInfo) \
    ENTRY(clGetProgramInfo) ENTRY(clReleaseCommandQueue) ENTRY(clReleaseContext) \
    ENTRY(clReleaseDevice) ENTRY(clReleaseEvent) ENTRY(clReleaseKernel) \
    ENTRY(clReleaseMemObject) ENTRY(clReleaseProgram) ENTRY(clRetainCommandQueue) \
    ENTRY(clRetainContext) ENTRY(clRetainDevice) ENTRY(clRetainEvent) ENTRY(clRetainKernel) \
    ENTRY(clRetainMemObject) ENTRY(clRetainProgram) ENTRY(clSetKernelArg) ENTRY(clWaitForEvents)
// clang-format on

namespace lacuna::opencl {

// Stands for the function that was found: it can be called, and its address can be taken.
template <typename Function>
struct EntryPoint {
    Function* found = nullptr;
    operator Function*() const { return found; }
    Function* operator&() const { return found; }
};

}  // namespace lacuna::opencl

// In the global namespace, because the bindings call ::clFinish and the like.
#define LACUNA_DECLARE(name) extern lacuna::opencl::EntryPoint<decltype(::name)> lacuna_##name;
LACUNA_OPENCL_ENTRIES(LACUNA_DECLARE)
#undef LACUNA_DECLARE

namespace lacuna::opencl {

// Looks the functions up, once for the process: first among the libraries already loaded, which
// Oclgrind relies on, then in libOpenCL.so.1. Returns why they were not found; empty if they were.
// Call it before any of these functions.
std::string why_no_loader();

}  // namespace lacuna::opencl

// The bindings call the functions by these names, so that no symbol here clashes with a program's
// own OpenCL. Messages keep OpenCL's names.
// clang-format off
#ifndef LACUNA_OPENCL_OWN_NAMES
#define clBuildProgram lacuna_clBuildProgram
#define clCreateBuffer lacuna_clCreateBuffer
#define clCreateCommandQueueWithProperties lacuna_clCreateCommandQueueWithProperties
#define clCreateContext lacuna_clCreateContext
#define clCreateKernel lacuna_clCreateKernel
#define clCreateProgramWithSource lacuna_clCreateProgramWithSource
#define clEnqueueFillBuffer lacuna_clEnqueueFillBuffer
#define clEnqueueMapBuffer lacuna_clEnqueueMapBuffer
#define clEnqueueNDRangeKernel lacuna_clEnqueueNDRangeKernel
#define clEnqueueReadBuffer lacuna_clEnqueueReadBuffer
#define clEnqueueUnmapMemObject lacuna_clEnqueueUnmapMemObject
#define clEnqueueWriteBuffer lacuna_clEnqueueWriteBuffer
#define clFinish lacuna_clFinish
#define clFlush lacuna_clFlush
#define clGetEventProfilingInfo lacuna_clGetEventProfilingInfo
#define clGetDeviceIDs lacuna_clGetDeviceIDs
#define clGetDeviceInfo lacuna_clGetDeviceInfo
#define clGetPlatformIDs lacuna_clGetPlatformIDs
#define clGetPlatformInfo lacuna_clGetPlatformInfo
#define clGetProgramBuildInfo lacuna_clGetProgramBuildInfo
#define clGetProgramInfo lacuna_clGetProgramInfo
#define clReleaseCommandQueue lacuna_clReleaseCommandQueue
#define clReleaseContext lacuna_clReleaseContext
#define clReleaseDevice lacuna_clReleaseDevice
#define clReleaseEvent lacuna_clReleaseEvent
#define clReleaseKernel lacuna_clReleaseKernel
#define clReleaseMemObject lacuna_clReleaseMemObject
#define clReleaseProgram lacuna_clReleaseProgram
#define clRetainCommandQueue lacuna_clRetainCommandQueue
#define clRetainContext lacuna_clRetainContext
#define clRetainDevice lacuna_clRetainDevice
#define clRetainEvent lacuna_clRetainEvent
#define clRetainKernel lacuna_clRetainKernel
#define clRetainMemObject lacuna_clRetainMemObject
#define clRetainProgram lacuna_clRetainProgram
#define clSetKernelArg lacuna_clSetKernelArg
#define clWaitForEvents lacuna_clWaitForEvents
#endif
// clang-format on
