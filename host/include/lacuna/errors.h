// What the functions of Lacuna throw.
#pragma once

#include <lacuna/export.h>

#include <stdexcept>
#include <string>

namespace LACUNA_API lacuna {

class Error : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The request cannot be met. option() is the command's name for the field, without dashes; value()
// what it was; reason() what is allowed, where other options are written --NAME. what() is
// "OPTION VALUE: REASON".
class BadRequest : public Error {
public:
    BadRequest(const std::string& option, const std::string& value, const std::string& reason)
        : Error(option + " " + value + ": " + reason),
          option_(option),
          value_(value),
          reason_(reason) {}
    const std::string& option() const { return option_; }
    const std::string& value() const { return value_; }
    const std::string& reason() const { return reason_; }

private:
    std::string option_, value_, reason_;
};

// The set asked for would take more memory than there is, or than RunOn::memory_limit_bytes.
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
