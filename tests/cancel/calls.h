// A call of each public function that may take long, and of each way of working that it has.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace lacuna::tests {

struct Call {
    std::string name;  // the function's, then what is special
    std::function<void()> run;

    std::string function() const { return name.substr(0, name.find(' ')); }
};

// The calls with `size` times as much work as the least.
std::vector<Call> calls(std::size_t size);

}  // namespace lacuna::tests
