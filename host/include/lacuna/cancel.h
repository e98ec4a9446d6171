// Ends functions of Lacuna early, also those that have no observer, such as draw_mask() and
// progressive_order(). Link lacuna.
#pragma once

#include <lacuna/errors.h>
#include <lacuna/export.h>

#include <functional>

namespace LACUNA_API lacuna {

// While a CancelScope lives, every function of Lacuna that its thread calls asks `keep_going` now
// and then, on that thread. If it returns false, the function throws Cancelled and does not ask
// again. If it throws, the function ends with that exception. Functions that have an observer or a
// keep_going of their own ask both. Scopes nest: all that live are asked. A scope must end on the
// thread that made it, before the scopes that were made earlier.
//
//     std::atomic<bool> stop = false;  // set by another thread
//     const lacuna::CancelScope scope([&] { return !stop; });
//     const lacuna::Mask mask = lacuna::draw_mask(rings, {1, 1}, 1e-5);
//
// It is not asked while a library that Lacuna uses parses or joins all of a file at once, which may
// take a second for each 50 MB.
class CancelScope {
public:
    explicit CancelScope(std::function<bool()> keep_going);
    CancelScope(const CancelScope&) = delete;
    CancelScope& operator=(const CancelScope&) = delete;
    ~CancelScope();

    // Throws Cancelled if a scope of this thread that is older than this one returns false.
    void ask_older() const;

private:
    friend void ask();
    static void ask_from(const CancelScope* scope);

    std::function<bool()> keep_going_;
    const CancelScope* older_;
};

}  // namespace lacuna
