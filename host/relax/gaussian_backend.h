// The interface of a backend for the descent of the Gaussian energy.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "relax/gaussian.h"

namespace lacuna::relaxing {

// Moves the spots of one field. Whatever the order of its work, each step is exactly as in
// docs/design.md, section 9: all forces from the positions before the step, then all momenta, then
// all positions. Throws DeviceError, and Cancelled if the watch returns false.
class GaussianBackend {
public:
    virtual ~GaussianBackend() = default;

    virtual std::string device() const = 0;
    virtual void descend(std::uint32_t pace) = 0;
    // Waits until the queue is idle. In the order given.
    virtual std::vector<Spot> spots() = 0;
    // Called now and then during a long step, on the calling thread; false cancels the run.
    virtual void watch(std::function<bool()> may_go_on) = 0;
};

}  // namespace lacuna::relaxing
