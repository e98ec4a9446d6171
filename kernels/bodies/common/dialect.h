// Names for constructs that OpenCL C and GLSL spell differently, defined for both.
//
// A body is the loop of one kernel, written once. It uses the kernel's buffers by name:
// AT(statuses, i) is a word of the buffer `statuses`; LOAD(Draw, draws, i) and STORE(boxes, i, box)
// are for buffers whose elements have several words (portable/elements.h). A function that uses
// buffers has MEMORY before its parameters and is called with ON before its arguments: in OpenCL
// they pass a struct of pointers, in GLSL they are empty. KERNEL comes first: it defines the
// kernel, which calls serve(arguments, item), and in GLSL its buffers.
#ifndef LACUNA_BODIES_DIALECT_H
#define LACUNA_BODIES_DIALECT_H
#ifndef __OPENCL_C_VERSION__
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#endif
#include "portable/failure.h"
#include "portable/kernels.h"
#include "portable/report.h"
#include "portable/status.h"

#if defined(__OPENCL_C_VERSION__)
#define LACUNA_MEMBER(type, name) global type* name;
typedef struct Memory {
    LACUNA_BUFFERS(LACUNA_MEMBER)
} Memory;
#define BODY static inline
#define MEMORY const Memory memory,
#define ON memory,
#define AT(name, i) memory.name[i]
#define LOAD(Type, name, i) memory.name[i]
#define STORE(name, i, element) memory.name[i] = (element)
// Reads a word that other items may change at the same time, if an old value is good enough.
// Oclgrind reports a race unless the read is atomic, which makes a verb up to three times as slow.
#if defined(LACUNA_ATOMIC_LOOKS)
#define LOOK_AT(name, i) atomic_or(&memory.name[i], 0u)
#else
#define LOOK_AT(name, i) (*(volatile global u32*)&memory.name[i])
#endif
#define ATOMIC_ADD(name, i, value) atomic_add(&memory.name[i], value)
#define ATOMIC_AND(name, i, value) atomic_and(&memory.name[i], value)
#define ATOMIC_OR(name, i, value) atomic_or(&memory.name[i], value)
#define ATOMIC_MAX(name, i, value) atomic_max(&memory.name[i], value)
#define ATOMIC_SET(name, i, value) atomic_xchg(&memory.name[i], value)

#define LACUNA_PARAMETER(number, access, type, name) , global type* restrict name
#define LACUNA_PUT(number, access, type, name) memory.name = name;
#define KERNEL(name, serve, Arguments, LIST)                                    \
    BODY void serve(MEMORY const Arguments a, const u32 item);                  \
    kernel void name(const Arguments arguments LIST(LACUNA_PARAMETER)) {        \
        Memory memory;                                                          \
        LIST(LACUNA_PUT)                                                        \
        serve(memory, arguments, arguments.first_item + (u32)get_global_id(0)); \
    }

#else  // GLSL; glslang, too, pastes tokens with ##
#define BODY
#define MEMORY
#define ON
#define AT(name, i) name[i]
#define LOAD(Type, name, i) Type##_of(name[i].words)
#define STORE(name, i, element) name[i].words = words_of(element)
#define LOOK_AT(name, i) name[i]
#define ATOMIC_ADD(name, i, value) atomicAdd(name[i], value)
#define ATOMIC_AND(name, i, value) atomicAnd(name[i], value)
#define ATOMIC_OR(name, i, value) atomicOr(name[i], value)
#define ATOMIC_MAX(name, i, value) atomicMax(name[i], value)
#define ATOMIC_SET(name, i, value) atomicExchange(name[i], value)

#define READ readonly restrict
#define WRITE writeonly restrict
#define BOTH restrict
#define SHARED coherent restrict
#define LACUNA_LAYOUT(number, access, type, name)            \
    layout(binding = number) access buffer Binding##number { \
        WordsOf##type name[];                                \
    };
#define KERNEL(name, serve, Arguments, LIST)                              \
    layout(local_size_x_id = 0) in;                                       \
    layout(push_constant) uniform Constants {                             \
        Arguments arguments;                                              \
    };                                                                    \
    LIST(LACUNA_LAYOUT)                                                   \
    void serve(const Arguments a, const u32 item);                        \
    void main() {                                                         \
        serve(arguments, arguments.first_item + gl_GlobalInvocationID.x); \
    }
#endif

// Raises the flag if earlier loops were ended early (portable/failure.h). `number` is any value
// that the compiler does not know.
#define CHECK_TURNS(number, flag) \
    if (!has_turns_left(number)) ATOMIC_OR(report, FAILURE_WORD, flag)

#endif
