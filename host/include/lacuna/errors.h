// What the functions of Lacuna throw.
#pragma once

#include <lacuna/export.h>

#include <stdexcept>
#include <string>

namespace LACUNA_API lacuna {

class Error : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The request cannot be met. what() is "OPTION VALUE: what is allowed"; option() is the command's
// name for the field, without dashes.
class BadRequest : public Error {
public:
    BadRequest(const std::string& option, const std::string& value, const std::string& allowed)
        : Error(option + " " + value + ": " + allowed), option_(option) {}
    const std::string& option() const { return option_; }

private:
    std::string option_;
};

// The set asked for would take more memory than there is, or than Place::memory_limit_bytes.
class MemoryRefused : public BadRequest {
    using BadRequest::BadRequest;
};

// The backend or device that was asked for is missing or cannot be used.
class Unavailable : public Error {
    using Error::Error;
};

// A device failed during the work. what() names the call, the error code and the driver's log.
class DeviceError : public Error {
    using Error::Error;
};

// Observer::keep_going returned false.
class Cancelled : public Error {
public:
    Cancelled() : Error("cancelled") {}
};

}  // namespace lacuna
