# What happens where a backend's packages are missing.
include_guard()
set(LACUNA_REQUIRE "$ENV{LACUNA_REQUIRE}" CACHE STRING
    "Backends that must not be left out: opencl, vulkan")

# lacuna_leave_out(BACKEND MISSING PACKAGES) says what is missing, and the Debian packages that have
# it; an error where LACUNA_REQUIRE names the backend.
function(lacuna_leave_out backend missing packages)
    set(message "${missing} (Debian: ${packages})")
    if("${LACUNA_REQUIRE}" MATCHES "${backend}")
        message(FATAL_ERROR "${message}")
    endif()
    message(STATUS "${message}. Lacuna is built without the backend ${backend}.")
endfunction()
