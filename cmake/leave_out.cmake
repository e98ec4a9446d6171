# Leaves out a backend, kinds of pictures, meshes, or lacuna-mpi, where their packages are missing.
include_guard()
set(LACUNA_REQUIRE "$ENV{LACUNA_REQUIRE}" CACHE STRING
    "What must not be left out: opencl, vulkan, heif, assimp, mpi")

# lacuna_leave_out(WHAT NAME MISSING PACKAGES) prints what is missing, and the Debian packages that
# contain it. It is an error if LACUNA_REQUIRE has the name.
function(lacuna_leave_out what name missing packages)
    set(message "${missing} (Debian: ${packages})")
    if("${LACUNA_REQUIRE},$ENV{LACUNA_REQUIRE}" MATCHES "${name}")
        message(FATAL_ERROR "${message}")
    endif()
    message(STATUS "${message}. Lacuna is built without ${what}.")
endfunction()
